"""Draws what a texel's basis loses: bench/report bases FOLDER, where FOLDER has bases.json.

Writes charts/bases.png, the errors of all bases, and charts/bases-tilt.png, their answers as the normal tilts.
"""

import json
from pathlib import Path

from matplotlib.ticker import FuncFormatter
from report.front import front_of
from report.sheet import SMALL, Sheet, plain_axes
from report.study.styles import colour_of_weight
from report.text import machine_text

NO_DIFFERENCE = 0.02  # between the errors of two bases
LEAST_PERCENT = 1e-3  # the logarithmic axis ends somewhere
CURVES = ("L0/normalised", "F0/flux", "F1/radiance", "L2/radiance", "F2/radiance", "L4/radiance")
FLOATS, HALVES = "o", "s"
NAMED_BELOW = ("YF1", "YF2", "F0", "F2", "F1")  # have points right above them
USUAL_WEIGHTS = {"L0": "normalised", "F0": "flux"}  # radiance is that of the others


def has_usual_weight(row):
    return row["fields"]["weight"] == USUAL_WEIGHTS.get(row["fields"]["basis"], "radiance")


def colour_of(row):
    return row["style"]["colour"] if has_usual_weight(row) else colour_of_weight(row["style"]["colour"], row["fields"]["weight"])


def label_of(row):
    """What a reader calls it: the weight is said where it is not the usual one."""
    name, weight = row["fields"]["basis"], row["fields"]["weight"]
    return name if has_usual_weight(row) else f"{name} {weight}"


def is_half(row):
    return row["fields"]["half"]


def draw_light(axes, rows, light):
    front = front_of(rows, lambda row: row["bytes_per_texel"], lambda row: row["mean"], NO_DIFFERENCE)
    shown = [max(row["mean"], LEAST_PERCENT) for row in front]
    axes.step(
        [row["bytes_per_texel"] for row in front],
        shown,
        where="post",
        color="#bbbbbb",
        linewidth=1.2,
        zorder=1,
        label="least error for the bytes",
    )
    for row in rows:
        mean = max(row["mean"], LEAST_PERCENT)
        half = is_half(row)
        axes.plot(
            row["bytes_per_texel"],
            mean,
            HALVES if half else FLOATS,
            color=colour_of(row),
            markerfacecolor=colour_of(row) if half else "white",
            markersize=5,
            linestyle="none",
            zorder=3,
        )
        if half or not has_usual_weight(row):
            axes.annotate(
                label_of(row),
                (row["bytes_per_texel"], mean),
                (5, -9 if label_of(row) in NAMED_BELOW else 4),
                textcoords="offset points",
                fontsize=SMALL,
                color=colour_of(row),
            )
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.set_xticks([6, 12, 24, 54, 108, 216], ["6", "12", "24", "54", "108", "216"])
    axes.minorticks_off()
    axes.set_xlim(5, 320)
    axes.yaxis.set_major_formatter(FuncFormatter(lambda percent, _: f"{percent:g}"))
    plain_axes(axes, light, "bytes of a texel", "error, %")
    axes.grid(True, axis="y", which="major", linewidth=0.4, alpha=0.6)
    axes.set_axisbelow(True)


def errors_chart(document):
    rows = document["rows"]
    lights = list(dict.fromkeys(row["light"] for row in rows))
    context = document["context"]
    words = (
        "Squares: halves, named; circles: the same in floats, or another weight. Mean over the environments of the root mean "
        "square over the shading normals within 60 degrees, over the mean of the truth; errors below "
        f"{LEAST_PERCENT:g} % are drawn there. {max(row['environments'] for row in rows)} environments of each "
        f"random kind, seed {context['seed']}; {machine_text(context)}"
    )
    sheet = Sheet(2, 2, (4.6, 3.4), "What a texel's basis loses at tilted normals, and its bytes", words, legend_lines=1)
    panels = [axes for row in sheet.panels for axes in row]
    for axes, light in zip(panels, lights):
        draw_light(axes, [row for row in rows if row["light"] == light], light)
    sheet.legend(1)
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
        row = next(row for row in document["rows"] if row["basis"] == basis)
        axes.plot(
            tilt["degrees"],
            tilt["series"][basis],
            color=colour_of(row),
            linewidth=1.4,
            linestyle="--" if basis == CURVES[0] else "-",
            label=label_of(row),
        )
    plain_axes(axes, "", "degrees between shading and geometric normal, positive towards the light", "irradiance")
    axes.set_xlim(tilt["degrees"][0], tilt["degrees"][-1])
    axes.grid(True, linewidth=0.4, alpha=0.6)
    sheet.legend(3)
    return sheet


def main(arguments):
    folder = Path(arguments[0])
    document = json.loads((folder / "bases.json").read_text())
    errors_chart(document).save(folder / "charts" / "bases.png")
    tilt_chart(document).save(folder / "charts" / "bases-tilt.png")
