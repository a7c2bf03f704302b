"""Measured errors over the targets they were to meet."""

from report.fit.promise_rows import KINDS
from report.sheet import Sheet, plain_axes
from report.text import machine_text

COLOURS = {True: "#1f77b4", False: "#bbbbbb"}
LOWEST, HIGHEST = 0.4, 1.6


def draw(document, file):
    rows = [row for row in document["rows"] if row.get("measured")]
    targets = sorted({row["target"] for row in document["rows"]}, reverse=True)
    first, count = document["rooms"]["first"], document["rooms"]["count"]
    words = (
        "Each dot is a run with a seed that the fit has not seen: its error over the target, the reference's own error taken off. "
        "Blue: fit was sure. Grey: it said that it was not. Below the line the target is met. Triangles are beyond the axis. " + machine_text(document["context"])
    )
    sheet = Sheet(len(KINDS), len(targets), (3.6, 2.4), f"Does fit keep its word? Rooms {first} to {first + count - 1}", words)
    for panels, (kind, name) in zip(sheet.panels, KINDS.items()):
        for axes, target in zip(panels, targets):
            draw_panel(axes, [row for row in rows if row["map"] == kind and row["target"] == target], target)
            plain_axes(axes, f"{name}, {100 * target:g} %", "room", "error / target")
            axes.set_xlim(first - 1, first + count)
    sheet.save(file)


def draw_panel(axes, rows, target):
    axes.axhline(1, color="#444444", linewidth=0.8)
    for row in rows:
        room = int(row["room"].rsplit("-", 1)[1])
        ratios = [error / target for error in row["measured"]]
        axes.plot([room] * len(ratios), ratios, ".", markersize=3, color=COLOURS[row["sure"]])
        beyond = sum(ratio > HIGHEST for ratio in ratios)
        axes.plot([room] * beyond, [HIGHEST - 0.03] * beyond, "^", markersize=4, color=COLOURS[row["sure"]])
    axes.set_ylim(LOWEST, HIGHEST)
