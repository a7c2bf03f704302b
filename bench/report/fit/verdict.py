"""What each scene needs, by `shlmbench fit`: bench/report fit-verdict FIT.json... prints a table in Markdown.

Verified runs count as measured; where a target is out of reach the reason stands in place of a method.
"""

import sys
from pathlib import Path

from report.fit.search import KINDS, cost, figure, read_fit, root_mean
from report.study.data import StudyError

HEAD = (
    "| scene | target % | least | map | hits | bytes | seconds | estimated % | measured % "
    "| without the worst 0.1 % of points | runs that meet it |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n"
)


def bytes_text(size):
    return f"{size / 2**20:,.1f} MiB" if size >= 2**20 else f"{size / 2**10:,.0f} KiB"


def row(fit, kind):
    entry = fit[kind]
    start = f"| {fit['scene']} | {figure(100 * fit['target'])} | {fit['least']} | "
    if not entry["reached"]:
        return start + f"{kind.replace('_', ' ')}: {entry['reason']} | - | - | - | - | - | - | - |\n"
    choice = entry["choice"]
    runs = entry.get("verified", [])
    errors = [run["error"] for run in runs]
    measured = 100 * root_mean(error**2 for error in errors)
    without_worst = 100 * root_mean(run["error"] ** 2 * (1 - run["worst_share"]) for run in runs)
    met = f"{sum(error <= fit['target'] for error in errors)} of {len(errors)}" if errors else "-"
    return start + (
        f"{choice['method']} | {choice['hits']:.2g} | {bytes_text(cost(entry, 'bytes'))} | {cost(entry, 'seconds'):.2g} | "
        f"{figure(100 * choice['error'])} | {figure(measured)} | {figure(without_worst)} | {met} |\n"
    )


def main(arguments):
    try:
        fits = [read_fit(Path(path)) for path in arguments]
    except StudyError as error:
        print(error, file=sys.stderr)
        return 2
    print(HEAD + "".join(row(fit, kind) for fit in fits for kind in KINDS), end="")
    return 0
