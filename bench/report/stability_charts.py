"""Draws a chart for each stability case: bench/report stability FOLDER, where FOLDER has stability.json.

Theory is drawn as a line under the measured points, which carry their 95 % confidence.
"""

import json
from pathlib import Path

from report.sheet import Sheet, plain_axes
from report.text import machine_text

COLOURS = ("#0b6fb8", "#cf2f2a", "#2f9e6e", "#b08d12", "#7a5ea8", "#202020", "#d6338a", "#8a5a2b")
MARKERS = "o^sDvPX*"


def draw_curve(axes, curve, colour, marker):
    points = [point for point in curve["points"] if point["mean"] is not None]
    at = [point["at"] for point in points]
    judged = curve["expected"] != "shown"
    label = curve["name"] + ("" if judged else " (for comparison)")
    if judged:
        theory = [point["predicted"] for point in curve["points"]]
        dashes = "--" if curve["expected"] == "at most" else "-"
        axes.plot([p["at"] for p in curve["points"]], theory, dashes, color=colour, linewidth=3.2, alpha=0.35, zorder=1)
    axes.errorbar(
        at,
        [point["mean"] for point in points],
        [point["confidence"] for point in points],
        fmt=marker,
        color=colour,
        markerfacecolor=colour if judged else "white",
        markersize=4.5,
        capsize=2.5,
        linewidth=1,
        linestyle="none" if judged else ":",
        label=label,
        zorder=3,
    )
    for point in points:
        if not point["passed"]:
            axes.plot(point["at"], point["mean"], "x", color="black", markersize=11, zorder=4)


def chart(row, context):
    words = (
        f"Wide lines: theory, dashed where it is an upper bound. Points: means over {row['seeds']} seeds with 95 % confidence; hollow: not "
        f"judged; a cross: outside its band. {row['scene']} {machine_text(context)}"
    )
    sheet = Sheet(1, 1, (6.8, 4.0), row["name"], words, legend_lines=(len(row["curves"]) + 1) // 2, left=0.9)
    axes = sheet.panels[0][0]
    for number, curve in enumerate(row["curves"]):
        draw_curve(axes, curve, COLOURS[number % len(COLOURS)], MARKERS[number % len(MARKERS)])
    if row["logarithmic_swept"]:
        axes.set_xscale("log")
    if row["logarithmic_measured"]:
        axes.set_yscale("log")
    plain_axes(axes, "", row["swept"], row["measured"])
    axes.grid(True, linewidth=0.4, alpha=0.6)
    sheet.legend(2)
    return sheet


def main(arguments):
    folder = Path(arguments[0])
    document = json.loads((folder / "stability.json").read_text())
    for row in document["rows"]:
        chart(row, document["context"]).save(folder / "charts" / f"{row['name']}.png")
