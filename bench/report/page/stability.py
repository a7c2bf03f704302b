"""Every stability case: what fails where, theory beside data, how near to the limit."""

from report.page.images import image
from report.page.markup import joined, table, tag
from report.page.words import MISSING, origin_text, plural
from report.text import number_text

NEAR = 0.8  # of the band
MISSING_TEXT = MISSING.format("build/release/shlmbench stability --out results/stability")


def used(curve, point):
    """How much of its band a judged point uses; None where nothing is judged."""
    if curve["expected"] == "shown" or point["mean"] is None or point["predicted"] is None:
        return None
    above = point["mean"] - point["predicted"]
    distance = abs(above) if curve["expected"] == "equal" else max(0.0, above)
    return distance / point["band"] if point["band"] else (0.0 if distance == 0 else float("inf"))


def most_used(case):
    return max((share for curve in case["curves"] for p in curve["points"] if (share := used(curve, p)) is not None), default=0.0)


def state(case):
    return "failing" if not case["passed"] else "near" if most_used(case) >= NEAR else "fine"


BADGES = {"failing": ("✗", "not as predicted", "fails"), "near": ("◐", "near the limit", "if"), "fine": ("✓", "as predicted", "holds")}


def badge(kind):
    symbol, words, cls = BADGES[kind]
    return tag("span", tag("span", symbol, aria_hidden="true"), " ", words, cls=f"badge {cls}")


def point_row(curve, point):
    share = used(curve, point)
    theory = number_text(point["predicted"]) if curve["expected"] != "shown" else "-"
    bound = "at most " if curve["expected"] == "at most" else ""
    return (
        curve["name"],
        number_text(point["at"]),
        f"{bound}{theory}",
        number_text(point["mean"], 4),
        f"± {number_text(point['confidence'], 2)}",
        "not judged" if share is None else f"{100 * share:.0f} % of its band",
    )


def case_block(results, folder, case):
    chart = folder / "charts" / f"{case['name']}.png"
    rows = [point_row(curve, point) for curve in case["curves"] for point in curve["points"]]
    words = tag(
        "summary",
        tag("b", case["name"]),
        " ",
        badge(state(case)),
        " ",
        tag("span", case["purpose"], cls="purpose"),
    )
    return tag(
        "details",
        words,
        tag("p", tag("b", "Scene: "), case["scene"]),
        tag("p", tag("b", "Theory: "), case["theory"]),
        tag("p", tag("b", "What to do: "), case["advice"]),
        tag("p", tag("a", image(results, results.link(chart), f"{case['name']}: theory and data"), href=results.link(chart))) if chart.is_file() else None,
        tag("p", f"{case['measured']} over {case['swept']}; {case['seeds']} seeds, ± 95 % confidence.", cls="origin"),
        table(("curve", case["swept"], "theory", "measured", "confidence", "distance from theory"), rows),
        cls="case",
        data_state=state(case),
    )


def finding(cases):
    kinds = [state(case) for case in cases]
    points = sum(used(curve, point) is not None for case in cases for curve in case["curves"] for point in curve["points"])
    near = kinds.count("near")
    return (
        f"{len(kinds) - kinds.count('failing')} of {len(cases)} cases are as theory predicts, over {points} judged points; "
        f"{near or 'none'} {'comes' if near < 2 else 'come'} within {100 * (1 - NEAR):.0f} % of the edge of its band."
    )


def controls(cases):
    kinds = [state(case) for case in cases]
    chips = [("all", len(cases)), ("failing", kinds.count("failing")), ("near", kinds.count("near"))]
    names = {"all": "all", "failing": "failing", "near": "near the limit"}
    made = [
        tag("button", names[kind], " ", tag("small", count), type="button", cls="chip", data_show=kind, aria_pressed="true" if kind == "all" else "false")
        for kind, count in chips
    ]
    return tag("p", *made, cls="controls script-only", id="case-filter")


def section(results):
    if not results.stability:
        return tag("p", MISSING_TEXT)
    parts = []
    for source in results.stability:
        cases = sorted(source.document["rows"], key=most_used, reverse=True)
        parts += [
            tag("p", finding(cases), cls="finding"),
            tag("p", f"Small scenes whose answer is known. Nearest to the limit first. {origin_text(source.context)}; {plural(len(cases), 'case')}.", cls="origin"),
            controls(cases),
            tag("div", *(case_block(results, source.folder, case) for case in cases), id="cases"),
        ]
    return joined(parts)
