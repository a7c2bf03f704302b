"""How charts look: colours of the methods, shaded where a chart has many of a kind, and sheets of panels with room for words."""

import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter, NullLocator
from PIL import Image

from study_methods import FIXED_K, FIXED_RADIUS, GROWING_K, LIGHT_MAP
from study_text import number_text

DPI = 130
SMALL = 7  # pt, the smallest there is
CHARACTERS_PER_INCH = 18  # at SMALL
TITLE_CHARACTERS_PER_INCH = 11
SHORT = 1.5  # decades
TITLE, PANEL_TITLE = 0.5, 0.3  # inches

MAPS = {
    FIXED_K: ("Blues", 0.55, 0.95),
    GROWING_K: ("Greens", 0.55, 0.9),
    FIXED_RADIUS: ("Purples", 0.55, 0.9),
}
WEIGHT_BLENDS = {"radiance": ("#000000", 0.0), "normalised": ("#000000", 0.4), "flux": ("#ffffff", 0.5)}  # towards which, how far
GATHER_DASHES = {"own": (0, (1, 1.2)), "bilinear": (0, (4, 1.5)), "surface4": "-", "knn4": (0, (6, 1, 1, 1))}
OTHER_GATHER = (0, (6, 1.5, 1, 1.5))
KERNEL_DASHES = {"cone": (0, (4, 1.5)), "epanechnikov": (0, (1, 1.2))}
GATHER_MARKERS = {"surface4": "^", "knn4": "<", "own": "v", "bilinear": "D"}
OTHER_GATHER_MARKER = "*"
PLACEMENT_FILLS = {"": "full", "uv": "left", "face": "right"}
FAMILY_MARKERS = {FIXED_K: "o", GROWING_K: "s", FIXED_RADIUS: "p"}


def colour_of_weight(colour, weight):
    """The basis's own for the radiance weight, darker where it is normalised, paler for flux."""
    towards, share = WEIGHT_BLENDS[weight]
    return tuple((1 - share) * np.array(to_rgb(colour)) + share * np.array(to_rgb(towards)))


class Styles:
    """Of all methods of a study: within a kind of photon map the colour darkens with k, C or the radius."""

    def __init__(self, methods):
        self._numbers = {f: sorted({m.number for m in methods if m.family == f}) for f in MAPS}
        self._texels = sorted({m.texels for m in methods if m.family == LIGHT_MAP and m.texels})

    def _shade(self, method):
        name, first, last = MAPS[method.family]
        numbers = self._numbers[method.family]
        along = numbers.index(method.number) / max(1, len(numbers) - 1)
        return matplotlib.colormaps[name](first + (last - first) * along)

    def of(self, method):
        """Keyword arguments of plot."""
        if method.family == LIGHT_MAP:
            colour = colour_of_weight(method.colour, method.weight)
            if method.texels:
                share = (self._texels.index(method.texels) + 1) / (len(self._texels) + 1)
                colour = matplotlib.colormaps["copper"](0.25 + 0.7 * share)
            dashes = GATHER_DASHES.get(method.gather, OTHER_GATHER)
            return {
                "color": colour,
                "marker": GATHER_MARKERS.get(method.gather, OTHER_GATHER_MARKER),
                "fillstyle": PLACEMENT_FILLS[method.placement],
                "linestyle": dashes,
            }
        if method.family in MAPS:
            return {
                "color": self._shade(method),
                "marker": FAMILY_MARKERS[method.family],
                "linestyle": KERNEL_DASHES.get(method.kernel, "-"),
            }
        return {"color": method.colour, "marker": method.marker, "linestyle": "-"}


class Sheet:
    """A grid of panels, laid out in inches, so that nothing overlaps however long the words are."""

    def __init__(
        self, rows, columns, panel, title, caption, gap=0.75, foot=0.5, legend_lines=0, left=0.75, head=0.0
    ):
        """`panel`: width, height; `gap`: between columns; `foot`: under every panel; `left`, `head`: of the
        whole sheet.

        `legend_lines`: of the legend under all panels, 0 for none.
        """
        width = left + columns * panel[0] + (columns - 1) * gap + 0.65
        lines = textwrap.wrap(caption, int(width * CHARACTERS_PER_INCH))
        title_lines = textwrap.wrap(title, int(width * TITLE_CHARACTERS_PER_INCH))
        top = head + TITLE + 0.18 * (len(title_lines) - 1)
        self._caption = 0.14 * len(lines) + 0.1
        bottom = self._caption + 0.16 * legend_lines + (0.1 if legend_lines else 0) + foot
        height = top + rows * panel[1] + (rows - 1) * (foot + PANEL_TITLE) + bottom
        self.figure, self.panels = plt.subplots(rows, columns, figsize=(width, height), squeeze=False)
        self.figure.subplots_adjust(
            left=left / width,
            right=1 - 0.65 / width,
            top=1 - top / height,
            bottom=bottom / height,
            wspace=gap / panel[0],
            hspace=(foot + PANEL_TITLE) / panel[1],
        )
        self.figure.text(0.5, 1 - 0.08 / height, "\n".join(title_lines), ha="center", va="top", fontsize=11)
        self.figure.text(
            0.1 / width,
            0.05 / height,
            "\n".join(lines),
            fontsize=SMALL,
            color="#444444",
            va="bottom",
            linespacing=1.3,
        )
        self._height = height

    def legend(self, columns):
        """One for all panels: every label once."""
        entries = {}
        for axes in self.panels.flat:
            for handle, label in zip(*axes.get_legend_handles_labels()):
                entries.setdefault(label, handle)
        self.figure.legend(
            entries.values(),
            entries.keys(),
            loc="lower center",
            ncol=columns,
            fontsize=SMALL + 0.5,
            frameon=False,
            handlelength=3.2,
            bbox_to_anchor=(0.5, self._caption / self._height),
            borderaxespad=0,
        )

    def save(self, path):
        for axes in self.figure.axes:
            for axis in (axes.xaxis, axes.yaxis):
                label_short_axis(axis)
        path.parent.mkdir(parents=True, exist_ok=True)
        self.figure.savefig(path, dpi=DPI)
        plt.close(self.figure)
        # A chart has few colours: with a palette it takes a third of the bytes. matplotlib needs Pillow anyway.
        with Image.open(path) as image:
            image.convert("RGB").quantize(256, dither=Image.Dither.NONE).save(path, optimize=True)


def label_short_axis(axis):
    """A logarithmic axis of less than SHORT decades may hold a single power of ten: plain numbers, and more of them."""
    low, high = sorted(axis.get_view_interval())
    if (
        axis.get_scale() != "log"
        or high >= low * 10**SHORT
        or isinstance(axis.get_major_locator(), FixedLocator)
    ):
        return
    axis.set_major_locator(LogLocator(subs=(1, 2, 3, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: number_text(value)))
    axis.set_minor_locator(NullLocator())


def log_log(axes, title, x_label, y_label):
    axes.set_xscale("log")
    axes.set_yscale("log")
    plain_axes(axes, title, x_label, y_label)
    axes.grid(True, which="major", linewidth=0.4, alpha=0.6)


def plain_axes(axes, title, x_label, y_label):
    axes.set_title(title, fontsize=9)
    axes.set_xlabel(x_label, fontsize=8)
    axes.set_ylabel(y_label, fontsize=8)
    axes.tick_params(labelsize=7.5)


def percent_axis(axes):
    """Relative RMS in per cent on the right of an axis of mean squared errors."""
    low, high = axes.get_ylim()
    ticks = [
        p
        for decade in range(-4, 6)
        for p in (10.0**decade, 2 * 10.0**decade, 5 * 10.0**decade)
        if low <= (p / 100) ** 2 <= high
    ]
    right = axes.twinx()
    right.set_yscale("log")
    right.set_ylim(low, high)
    right.yaxis.set_major_locator(FixedLocator([(p / 100) ** 2 for p in ticks]))
    right.yaxis.set_minor_locator(NullLocator())
    right.yaxis.set_minor_formatter(NullFormatter())
    right.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{100 * np.sqrt(max(y, 0)):g} %"))
    right.tick_params(labelsize=7.5)
    return right


def grid_shape(count):
    """Rows and columns for one panel a scene: at most two beside each other."""
    columns = min(2, max(1, count))
    return -(-count // columns), columns
