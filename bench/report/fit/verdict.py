"""What each scene needs, by `shlmbench fit`: bench/report fit-verdict FIT.json... prints a table in Markdown.

Bytes and time are medians of the verified runs, else as predicted; where a target is out of reach the reason stands in place of a method.
"""

import sys
from pathlib import Path

from report.fit.search import KINDS, cost, read_fit, root_mean
from report.markdown import table_text
from report.study.data import StudyError
from report.text import NOTHING, bytes_text, hits_text, seconds_text, share_text

HEADS = (
    "scene",
    "target",
    "least",
    "map",
    "method",
    "hits",
    "bytes",
    "time",
    "estimated",
    "measured",
    "without the worst 0.1 % of points",
    "runs that meet it",
)


def cells(fit, kind):
    entry = fit[kind]
    start = [fit["scene"], f"{100 * fit['target']:g}\u00a0%", fit["least"], kind.replace("_", " ")]
    if not entry["reached"]:
        return [*start, f"out of reach: {entry.get('reason', '')}", *[NOTHING] * (len(HEADS) - len(start) - 1)]
    choice, runs = entry["choice"], entry.get("verified", [])
    without_worst = root_mean(run["error"] ** 2 * (1 - run["worst_share"]) for run in runs)
    met = sum(run["error"] <= fit["target"] for run in runs)
    return [
        *start,
        choice["method"],
        hits_text(choice["hits"]),
        bytes_text(cost(entry, "bytes")),
        seconds_text(cost(entry, "seconds")),
        share_text(choice["error"]),
        share_text(root_mean(run["error"] ** 2 for run in runs)) if runs else "not verified",
        share_text(without_worst) if runs else NOTHING,
        f"{met} of {len(runs)}" if runs else NOTHING,
    ]


def main(arguments):
    try:
        fits = [read_fit(Path(path)) for path in arguments]
    except StudyError as error:
        print(error, file=sys.stderr)
        return 2
    print(table_text(HEADS, [cells(fit, kind) for fit in fits for kind in KINDS]), end="")
    return 0
