"""Draws what the light map that `shlmbench fit --explain` has chosen keeps, and where: bench/report explanation FOLDER.

Reads FOLDER/explanation.json and writes FOLDER/explanation.png: the picture that the camera sees, once by what each
block keeps and once by how wide it is.
"""

import json
from pathlib import Path

import numpy as np
from matplotlib.colors import LogNorm, to_rgb
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator
from report.sheet import SMALL, Sheet
from report.text import machine_text

NOTHING = "#ffffff"


def grid_of(document, key):
    return np.array(document[key]).reshape(document["height"], document["width"])


def draw_kinds(axes, kinds, colours):
    image = np.empty(kinds.shape + (3,))
    for kind in np.unique(kinds):
        image[kinds == kind] = to_rgb(colours.get(kind, NOTHING))
    axes.imshow(image, interpolation="nearest")
    shown = [kind for kind in colours if (kinds == kind).any()]
    share = {kind: 100 * (kinds == kind).sum() / (kinds != "").sum() for kind in shown}
    axes.legend(
        handles=[Patch(color=colours[kind], label=f"{kind} {share[kind]:.0f} %") for kind in shown],
        loc="upper center",
        bbox_to_anchor=(0.5, -0.02),
        ncol=len(shown),
        fontsize=SMALL + 0.5,
        frameon=False,
    )
    axes.set_title("What a block keeps, with shares of the picture", fontsize=9)


def draw_widths(figure, axes, widths):
    seen = np.where(widths > 0, widths, np.nan)
    low, high = widths_range(seen)
    shown = axes.imshow(seen, interpolation="nearest", cmap="viridis", norm=LogNorm(low, high))
    bar = figure.colorbar(shown, ax=axes, orientation="horizontal", fraction=0.06, pad=0.03)
    bar.ax.xaxis.set_major_locator(FixedLocator(round_widths(low, high)))
    bar.ax.xaxis.set_major_formatter(FuncFormatter(lambda width, _: f"{width:.3g}"))
    bar.ax.xaxis.set_minor_locator(NullLocator())
    bar.ax.tick_params(labelsize=SMALL + 0.5)
    axes.set_title("Width of a block, scene units", fontsize=9)


def round_widths(low, high):
    """Three ticks at least."""
    for digits in (1, 2, 5), (1, 1.5, 2, 3, 4, 5, 6, 7, 8):
        ticks = [digit * 10.0**power for power in range(-8, 9) for digit in digits]
        within = [tick for tick in ticks if low <= tick <= high]
        if len(within) >= 3:
            return within
    return [low, high]


def widths_range(seen):
    """Without the slivers of texels that a triangle's edge has left."""
    low, high = np.nanpercentile(seen, 1), np.nanmax(seen)
    return (low, high) if low < high else (0.9 * high, 1.1 * high)


def chart(document):
    choice = document["choice"]
    target = document["target"]
    wanted = f"{100 * target:g} %"
    reached = "" if document["reached"] else " (which it does not reach)"
    title = f"{document['scene']}, target {wanted}{reached}: {choice['method']}"
    words = (
        f"{choice['hits']:.3g} hits, estimated relative RMS error {100 * choice['error']:.3g} %, {choice['bytes'] / 1e6:.3g} MB. "
        f"White: no light map. Seed {document['seed']}; {machine_text(document['context'])}"
    )
    sheet = Sheet(1, 2, (5.2, 3.5), title, words, legend_lines=0, left=0.1)
    kinds, widths = sheet.panels[0]
    draw_kinds(kinds, grid_of(document, "kind"), document["colours"])
    draw_widths(sheet.figure, widths, grid_of(document, "block_width"))
    for axes in (kinds, widths):
        axes.set_xticks([])
        axes.set_yticks([])
    return sheet


def main(arguments):
    folder = Path(arguments[0])
    chart(json.loads((folder / "explanation.json").read_text())).save(folder / "explanation.png")
