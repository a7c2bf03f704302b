"""What `shlmbench fit` has chosen beside the best that a search by brute force has found.

    bench/report fit-search STUDY FIT.json...

STUDY is the folder of a `shlmbench study` over the methods that `shlmbench fit --list` prints. The search's best is
the least time, or the fewest bytes, in which any method of its grid reaches the target, interpolated between its sizes
as in the study's report. What fit chose costs what the study's own runs of that method cost at the chosen hits, so that
both sides have the same clock. Its errors are those of its verified runs.
"""

import json
import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from report.markdown import table_text
from report.study.curves import curves_of
from report.study.data import Study, StudyError
from report.study.targets import bytes_to_reach, time_to_reach, winners

KINDS = {"light_map": "shlm/", "photon_map": "photonmap/"}
HEADS = (
    "scene",
    "target %",
    "chosen",
    "hits",
    "estimated %",
    "measured %",
    "runs that meet it",
    "time / best",
    "fastest of the search",
    "bytes / best",
    "smallest of the search",
)


def root_mean(squares):
    """Not a number where there are none."""
    squares = list(squares)
    return math.sqrt(sum(squares) / len(squares)) if squares else math.nan


@dataclass(frozen=True)
class Verdict:
    """One kind of map in one fit. Ratios are not a number where the search has not reached the target, and where it has
    no runs of the chosen method on both sides of the chosen hits."""

    scene: str
    target: float
    method: str  # empty where fit says that the target is out of reach
    reason: str
    hits: float = math.nan
    estimated: float = math.nan
    measured: tuple = ()  # errors of the verified runs
    time_ratio: float = math.nan
    fastest: str = ""
    bytes_ratio: float = math.nan
    smallest: str = ""

    @property
    def measured_rms(self):
        return root_mean(error**2 for error in self.measured)

    @property
    def meeting(self):
        return sum(error <= self.target for error in self.measured)


def read_fit(path):
    """Raises StudyError where the file holds no fit."""
    try:
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
        for key in ("scene", "target", *KINDS):
            document[key]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StudyError(f"{path} cannot be read: {error}") from error
    return document


def best(curves, prefix, target, reach):
    """(name, cost) of the cheapest method of a kind; ("", NaN) where none reaches the target."""
    reaches = {name: reach(curve, target) for name, curve in curves.items() if name.startswith(prefix)}
    first = winners(reaches)
    return (first[0], reaches[first[0]].cost) if first else ("", math.nan)


def cost_in(curve, hits, cost_of):
    """What the study's runs of a method cost at so many hits; not a number beyond its sizes. A straight line in log-log."""
    sizes, costs = np.log(curve.array("hits")), np.log([cost_of(point) for point in curve.points])
    return math.exp(np.interp(math.log(hits), sizes, costs, left=math.nan, right=math.nan))


def cost(entry, column):
    """Median of the verified runs, else what was predicted."""
    runs = entry.get("verified", [])
    return float(np.median([run[column] for run in runs])) if runs else entry["choice"][column]


def verdict(fit, kind, curves):
    entry = fit[kind]
    fastest, seconds = best(curves, KINDS[kind], fit["target"], time_to_reach)
    smallest, least_bytes = best(curves, KINDS[kind], fit["target"], bytes_to_reach)
    found = {"scene": fit["scene"], "target": fit["target"], "fastest": fastest, "smallest": smallest}
    if not entry["reached"]:
        return Verdict(method="", reason=entry["reason"], **found)
    choice = entry["choice"]
    if curve := curves.get(choice["method"]):
        found["time_ratio"] = cost_in(curve, choice["hits"], lambda p: p.seconds) / seconds
        found["bytes_ratio"] = cost_in(curve, choice["hits"], lambda p: p.bytes) / least_bytes
    return Verdict(
        method=choice["method"],
        reason="",
        hits=choice["hits"],
        estimated=choice["error"],
        measured=tuple(run["error"] for run in entry.get("verified", [])),
        **found,
    )


def verdicts(study, fits):
    """Two for each fit, in the order of the fits. Raises StudyError where the study lacks a scene."""
    curves = curves_of(study)
    for fit in fits:
        if fit["scene"] not in curves:
            raise StudyError(f"{study.folder} has no measured row of {fit['scene']}")
    return [verdict(fit, kind, curves[fit["scene"]]) for fit in fits for kind in KINDS]


def figure(value, form="{:.3g}"):
    return "-" if math.isnan(value) else form.format(value)


def cells(v):
    return (
        v.scene,
        figure(100 * v.target),
        v.method or f"out of reach: {v.reason}",
        figure(v.hits),
        figure(100 * v.estimated),
        figure(100 * v.measured_rms),
        f"{v.meeting} of {len(v.measured)}" if v.measured else "-",
        figure(v.time_ratio, "{:.2f}"),
        v.fastest or "never",
        figure(v.bytes_ratio, "{:.2f}"),
        v.smallest or "never",
    )


def main(arguments):
    try:
        fits = [read_fit(Path(path)) for path in arguments[1:]]
        study = Study(arguments[0])
        print(table_text(HEADS, map(cells, verdicts(study, fits))), end="")
        for problem in study.problems:
            print(problem, file=sys.stderr)
    except StudyError as error:
        print(error, file=sys.stderr)
        return 2
    return 0
