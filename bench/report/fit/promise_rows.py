"""What fits promised and what was measured, a row for each kind of map, target and room."""

import math
import random
import statistics

from report.markdown import table_text
from report.text import machine_text, number_text

KINDS = {"light_map": "light map", "photon_map": "photon map"}


def measured_errors(fit, entry):
    """Relative RMS of each verified run, without the reference's own error."""
    own = fit.get("reference_error", 0)
    return [math.sqrt(max(0.0, run["error"] ** 2 - own**2)) for run in entry.get("verified", [])]


def row_of(fit, kind):
    entry = fit[kind]
    row = {"room": fit["scene"], "target": fit["target"], "map": kind, "reached": entry["reached"], "sure": entry["reached"] and entry["sure"]}
    row["pilot_seconds"] = fit["pilot"]["seconds"]
    if "doubt" in entry:
        row["doubt"] = entry["doubt"]
    if not entry["reached"]:
        return row | {"reason": entry["reason"]}
    choice = entry["choice"]
    row |= {"method": choice["method"], "hits": choice["hits"], "estimated": choice["error"], "bound": choice["bound"]}
    row |= {"noise": choice["noise"], "seconds": choice["seconds"]}
    return row | {"measured": measured_errors(fit, entry)}


def rows_of(fits):
    return [row_of(fit, kind) for fit in fits for kind in KINDS]


def mean_square(errors):
    return sum(error**2 for error in errors) / len(errors)


def ratio_of(row):
    """Measured over estimated error."""
    return math.sqrt(mean_square(row["measured"])) / row["estimated"]


def used_margin(row):
    """Of each run: what its squared error is above the estimate, in parts of the margin that fit took."""
    estimated = row["estimated"] ** 2
    return [(error**2 - estimated) / max(row["bound"] ** 2 - estimated, 1e-12) for error in row["measured"]]


def margin_of(rows):
    """What nine of ten runs use at most of fit's margin: (of these rooms, and at most of others of their kind, with which 95 of 100
    draws of as many of these rooms agree)."""
    by_room = {}
    for row in rows:
        by_room.setdefault(row["room"], []).extend(used_margin(row))
    rooms = list(by_room.values())
    draw = random.Random(1)
    drawn = [quantile([used for room in draw.choices(rooms, k=len(rooms)) for used in room], 0.9) for _ in range(1000)]
    return quantile([used for room in rooms for used in room], 0.9), quantile(drawn, 0.95)


def quantile(values, share):
    """Between the two nearest."""
    place = share * (len(values) - 1)
    low = math.floor(place)
    high = min(low + 1, len(values) - 1)
    values = sorted(values)
    return values[low] + (place - low) * (values[high] - values[low])


def figures_of(rows):
    """Of rows with measured runs."""
    runs = [(row["target"], error) for row in rows for error in row["measured"]]
    met = sum(error <= target for target, error in runs)
    if not rows:
        return {"choices": 0, "runs": 0, "runs_that_meet": 0}
    ratios = [ratio_of(row) for row in rows]
    spread = {name: quantile(ratios, share) for name, share in (("tenth", 0.1), ("median", 0.5), ("nine_tenths", 0.9))}
    dear = statistics.median(row["pilot_seconds"] / row["seconds"] for row in rows)
    pilot = statistics.median(row["pilot_seconds"] for row in rows)
    margin, at_most = margin_of(rows)
    figures = {"choices": len(rows), "runs": len(runs), "runs_that_meet": met, "measured_over_estimated": spread}
    return figures | {"pilot_seconds": pilot, "pilot_over_chosen": dear, "used_margin": {"nine_tenths": margin, "at_most": at_most}}


def summary_of(rows):
    done = [row for row in rows if row.get("measured")]
    sure, unsure = [row for row in done if row["sure"]], [row for row in done if not row["sure"]]
    summary = {"sure": figures_of(sure), "not_sure": figures_of(unsure), "out_of_reach": sum(not row["reached"] for row in rows)}
    targets = sorted({row["target"] for row in rows}, reverse=True)
    summary["by_target"] = [
        {"target": target, "map": kind} | figures_of([row for row in sure if row["target"] == target and row["map"] == kind])
        for target in targets
        for kind in KINDS
    ]
    return summary


HEADS = (
    "target %",
    "map",
    "sure choices",
    "runs that meet it",
    "measured / estimated: median",
    "tenth to nine tenths",
    "pilot s",
    "pilot / chosen run",
)


def cells_of(label, kind, figures):
    if figures["choices"] == 0:
        return [label, kind, "0", *["-"] * 5]
    spread = figures["measured_over_estimated"]
    span = f"{number_text(spread['tenth'])} to {number_text(spread['nine_tenths'])}"
    met = f"{figures['runs_that_meet']} of {figures['runs']}"
    pilot = [number_text(figures[key]) for key in ("pilot_seconds", "pilot_over_chosen")]
    return [label, kind, str(figures["choices"]), met, number_text(spread["median"]), span, *pilot]


def margin_words(sure):
    if sure["choices"] == 0:
        return ""
    used = sure["used_margin"]
    return (
        f"Nine of ten sure runs use at most {number_text(used['nine_tenths'])} of the margin that fit takes, and with 95 of 100 draws of as many of "
        f"these rooms at most {number_text(used['at_most'])}. With 1 just nine of ten stay within their bound.\n"
    )


def table_of(document):
    summary, rooms = document["summary"], document["rooms"]
    rows = [cells_of(f"{100 * row['target']:g}", KINDS[row["map"]], row) for row in summary["by_target"]]
    rows += [cells_of("all", f"both, {words}", summary[key]) for words, key in (("sure", "sure"), ("not sure", "not_sure"))]
    last = rooms["first"] + rooms["count"] - 1
    return (
        f"Rooms {rooms['first']} to {last}; choices out of reach: {summary['out_of_reach']}. {machine_text(document['context'])}\n\n{table_text(HEADS, rows)}\n"
        "A run meets its target where its relative RMS error, without that of the reference, is at most the target. Pilot: the whole search.\n"
        + margin_words(summary["sure"])
    )
