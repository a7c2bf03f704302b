"""Draws what a texel's basis loses: bases_chart.py FOLDER, where FOLDER has bases.json.

Writes charts/bases.png, the errors of all bases, and charts/bases-tilt.png, their answers as the normal tilts.
"""

import json
import sys
from pathlib import Path

from matplotlib.ticker import FuncFormatter
from study_style import LIGHT_MAP_COLOURS, SMALL, Sheet, plain_axes
from study_text import machine_text

SLOT = 0.84  # of the room between two kinds of light
LEAST_PERCENT = 1e-3  # the logarithmic axis ends somewhere
CURVES = ("L0/normalised", "L1/radiance", "L2/radiance", "L4/radiance")
LABELS = {
    "L0/normalised": "flat (L0/normalised)",
    "L2/normalised": "L2/normalised",
    "L2/flux": "L2/flux (the paper read literally)",
}


def colour_of(basis):
    order, weight = basis.split("/")
    return LIGHT_MAP_COLOURS[weight][int(order[1:])]


def label_of(basis):
    return LABELS.get(basis, basis)


def text_of(percent):
    return f"{percent:.{3 if percent < 0.1 else 2 if percent < 1 else 1 if percent < 100 else 0}f}"


def draw_bar(axes, place, width, row, is_first):
    """The mean as a bar, the worst as its whisker, what was expected as a diamond and a dash."""
    mean, worst = max(row["mean"], LEAST_PERCENT), row["worst"]
    axes.bar(place, mean, width, color=colour_of(row["basis"]), label=label_of(row["basis"]))
    if row["environments"] > 1:
        axes.errorbar(
            place, mean, [[0], [worst - mean]], fmt="none", ecolor="#444444", capsize=3, linewidth=0.9
        )
    top = max(worst, mean, row["expected_worst"] or 0)
    axes.annotate(
        text_of(row["mean"]),
        (place, top),
        (0, 6),
        textcoords="offset points",
        ha="center",
        fontsize=SMALL,
    )
    marks = {"color": "black", "markeredgewidth": 1.2, "linestyle": "none", "zorder": 4}
    if row["expected_mean"]:  # a logarithmic axis has no 0
        label = "expected mean" if is_first else None
        axes.plot(place, row["expected_mean"], "D", markersize=4, markerfacecolor="white", label=label, **marks)
    if row["expected_worst"]:
        label = "expected worst" if is_first else None
        axes.plot(place, row["expected_worst"], "x", markersize=6, label=label, **marks)


def errors_chart(document):
    rows = document["rows"]
    lights = list(dict.fromkeys(row["light"] for row in rows))
    bases = list(dict.fromkeys(row["basis"] for row in rows))
    context = document["context"]
    words = (
        "Bars: mean over the environments, in numbers above; whiskers: the worst. Error: root mean square over "
        "the shading normals within 60 degrees, over the mean of the truth. Expected errors of 0 are not drawn. "
        f"{max(row['environments'] for row in rows)} environments of each random kind, seed {context['seed']}; "
        f"{machine_text(context)}"
    )
    sheet = Sheet(
        1, 1, (8.6, 4.2), "What a texel's basis loses at tilted normals", words, legend_lines=2
    )
    axes = sheet.panels[0][0]
    width = SLOT / len(bases)
    for row in rows:
        beside = (bases.index(row["basis"]) - 0.5 * (len(bases) - 1)) * width
        draw_bar(axes, lights.index(row["light"]) + beside, 0.92 * width, row, row is rows[0])
    axes.set_yscale("log")
    axes.set_ylim(LEAST_PERCENT, 400)
    axes.yaxis.set_major_formatter(FuncFormatter(lambda percent, _: f"{percent:g}"))
    plain_axes(axes, "", "", "error, %")
    axes.set_xticks(range(len(lights)), lights, fontsize=9)
    axes.grid(True, axis="y", which="major", linewidth=0.4, alpha=0.6)
    axes.set_axisbelow(True)
    sheet.legend(4)
    return sheet


def tilt_chart(document):
    tilt = document["tilt"]
    light = tilt["light_degrees"]
    words = (
        f"One light {light:g} degrees from the geometric normal; the shading normal tilts in its plane. "
        f"1: a plane that faces the light. {machine_text(document['context'])}"
    )
    title = "Irradiance as the normal tilts"
    sheet = Sheet(1, 1, (6.6, 3.9), title, words, legend_lines=2)
    axes = sheet.panels[0][0]
    axes.axhline(0, color="#888888", linewidth=0.7)
    axes.axvline(light, color="#888888", linewidth=0.7, linestyle=":")
    axes.text(light, 0.03, " light", fontsize=SMALL + 0.5, color="#666666")
    axes.plot(tilt["degrees"], tilt["truth"], color="black", linewidth=2.2, label="truth")
    for basis in CURVES:
        axes.plot(
            tilt["degrees"],
            tilt["series"][basis],
            color=colour_of(basis),
            linewidth=1.4,
            linestyle="--" if basis == CURVES[0] else "-",
            label=label_of(basis),
        )
    plain_axes(axes, "", "degrees between shading and geometric normal, positive towards the light", "irradiance")
    axes.set_xlim(tilt["degrees"][0], tilt["degrees"][-1])
    axes.grid(True, linewidth=0.4, alpha=0.6)
    sheet.legend(3)
    return sheet


def main():
    folder = Path(sys.argv[1])
    document = json.loads((folder / "bases.json").read_text())
    errors_chart(document).save(folder / "charts" / "bases.png")
    tilt_chart(document).save(folder / "charts" / "bases-tilt.png")


if __name__ == "__main__":
    main()
