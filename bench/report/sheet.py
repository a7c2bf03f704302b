"""Sheets of panels with room for words, and how their axes look."""

import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter, NullLocator
from PIL import Image

from report.text import number_text

DPI = 130
SMALL = 7  # pt, the smallest there is
CHARACTERS_PER_INCH = 18  # at SMALL
TITLE_CHARACTERS_PER_INCH = 11
SHORT = 1.5  # decades
TITLE, PANEL_TITLE = 0.5, 0.3  # inches


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
        save_chart(self.figure, path)


def save_chart(figure, path):
    """A chart has few colours: with a palette it takes a third of the bytes. matplotlib needs Pillow anyway."""
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=DPI)
    plt.close(figure)
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
