"""The paper's claims: verdict, condition, number, what it rests on, links."""

from report.claims.finding import PLAIN
from report.page.markup import details, joined, link, tag
from report.page.words import date_text, listed, plural

CHARTS = {  # claim -> the chart of its report that shows it
    "tracing-speed": "time-to-map",
    "constant-insert": "insert",
    "constant-memory": "bytes",
    "constant-gather": "gather",
    "faster-gather": "gather",
    "billion-hits": "memory-wall",
    "normal-maps": "tilt",
    "converges": "hits-methods",
}
FIGURES = {  # what a claim's number is; a claim that is not here has its number alone
    "tracing-speed": "time to a finished map, strongest photon map over light map",
    "constant-insert": "slowest over fastest insertion as the hits grow",
    "constant-memory": "the light map's bytes",
    "constant-gather": "slowest over fastest search as the hits grow",
    "faster-gather": "time of a search, strongest photon map over light map",
    "billion-hits": "rate of tracing into the light map",
    "normal-maps": "order 2 beside a traditional light map",
    "realtime": "what its light costs",
    "converges": "what is left of the error",
}
SYMBOLS = {"confirmed": "✓", "refuted": "✗", "conditional": "◐", "not decided": "?"}  # shape beside colour
CLASSES = {"confirmed": "holds", "refuted": "fails", "conditional": "if", "not decided": "open"}


def badge(verdict):
    symbol = tag("span", SYMBOLS.get(verdict, "·"), aria_hidden="true")
    return tag("span", symbol, " ", PLAIN.get(verdict, verdict), cls=f"badge {CLASSES.get(verdict, 'open')}")


def leading(verdicts, row):
    """(folder, finding) that the row's number and link are of."""
    name = (verdicts.folder / row["link"]).resolve().parent.name
    found = row["findings"]
    return (name, found[name]) if name in found else next(iter(found.items()))


def basis(results, name, finding):
    """4 scenes, 5 to 8 runs, AMD EPYC, 2026-11-30"""
    context = results.context_of(name) or {}
    runs = finding["runs"]
    span = "runs not said" if not runs else plural(runs[0], "run") if runs[0] == runs[1] else f"{runs[0]} to {runs[1]} runs"
    return f"{plural(len(finding['scenes']), 'scene')}, {span}, {context.get('machine', 'machine not recorded')}, {date_text(context.get('date'))}"


def links(results, verdicts, row, name):
    folder = (verdicts.folder / row["link"]).parent
    places = [
        ("chart", folder / "charts" / f"{CHARTS.get(row['claim'], '')}.png"),
        ("report", folder / "report.md"),
        ("data", folder / "compare.json"),
        ("data", folder / "summary.json"),
        ("data", folder / "realtime.json"),
    ]
    there = [link(results.link(path), word) for word, path in places if path.is_file()]
    return joined(there, " · ")


def long_text(row):
    """All that was measured, one paragraph a folder."""
    parts = [tag("p", tag("b", name), ": ", f["measured"], " ", f["condition"]) for name, f in row["findings"].items()]
    return details("all figures and conditions", *parts, *(tag("p", rest) for rest in row["rests_on"]))


def claim_row(results, verdicts, row):
    name, finding = leading(verdicts, row)
    meaning = FIGURES.get(row["claim"])
    condition = row["condition"]
    return tag(
        "tr",
        tag("td", badge(row["verdict"])),
        tag("td", tag("b", row["says"]), tag("p", condition) if condition else None, long_text(row), cls="claim"),
        tag("td", tag("b", row["figure"] or "no number yet"), tag("br"), tag("small", meaning) if meaning and row["figure"] else None),
        tag("td", basis(results, name, finding), tag("br"), tag("small", links(results, verdicts, row, name))),
        id=f"claim-{row['claim']}",
    )


BESIDE = (
    "Claims of speed and memory are held against two photon maps: the paper's, a tree that takes photons one by one, and the strongest one measured here. "
    "x is how many times."
)
BECAME = {  # of one claim, of several
    "confirmed": ("holds", "hold"),
    "conditional": ("holds under a condition", "hold under a condition"),
    "refuted": ("fails", "fail"),
    "not decided": ("is not decided yet", "are not decided yet"),
}


def finding_text(rows):
    """One sentence."""
    said = []
    for verdict, (one, several) in BECAME.items():
        count = sum(row["verdict"] == verdict for row in rows)
        said.append(f"{count or 'none'} {one if count < 2 else several}")
    return f"Of the paper's {len(rows)} claims {listed(said)}."


def section(results):
    verdicts = results.verdicts[0]
    heads = joined(tag("th", head, scope="col") for head in ("verdict", "the paper's claim", "number", "rests on"))
    body = joined(claim_row(results, verdicts, row) for row in verdicts.document)
    return joined(
        [
            tag("p", BESIDE),
            tag("table", tag("thead", tag("tr", heads)), tag("tbody", body), cls="claims"),
        ]
    )
