"""Rows of pictures within the same time and the same bytes: the reference at the left, HDR-FLIP maps below."""

from dataclasses import dataclass
from pathlib import Path

import matplotlib.image
import numpy as np

from report.sheet import Sheet
from report.study.methods import REFERENCE_LIGHT_MAP, REFERENCE_PHOTON_MAP
from report.text import bytes_text, hits_text, number_text, percent_text, seconds_text

SCALE = 2  # screen pixels per picture pixel
DPI = 130
BUDGET_HITS = 1e6
TOLERANCE = 1.1  # a run a tenth over the budget counts as within


@dataclass(frozen=True)
class Budget:
    text: str
    limit: float
    cost_of: object  # of a Point

    def largest_within(self, curve):
        """None where even the first size costs too much."""
        within = [p for p in curve.points if self.cost_of(p) <= TOLERANCE * self.limit]
        return within[-1] if within else None


def nearest_size(curve, hits):
    return min(curve.points, key=lambda p: abs(np.log(p.hits / hits)))


def same_time(curves):
    """What the reference photon map takes for a million hits; None where it was not measured."""
    if REFERENCE_PHOTON_MAP not in curves:
        return None
    point = nearest_size(curves[REFERENCE_PHOTON_MAP], BUDGET_HITS)
    text = f"time of {REFERENCE_PHOTON_MAP} at {hits_text(point.hits)} hits, {seconds_text(point.seconds)}"
    return Budget(text, point.seconds, lambda p: p.seconds)


def same_bytes(curves):
    """Those of the smallest reference photon map not below the reference light map, or the largest."""
    if REFERENCE_PHOTON_MAP not in curves:
        return None
    points = curves[REFERENCE_PHOTON_MAP].points
    least = (
        max((p.bytes for p in curves[REFERENCE_LIGHT_MAP].points), default=0)
        if REFERENCE_LIGHT_MAP in curves
        else 0
    )
    point = next((p for p in points if p.bytes >= least), points[-1])
    text = f"bytes of {REFERENCE_PHOTON_MAP} at {hits_text(point.hits)} hits, {bytes_text(point.bytes)}"
    return Budget(text, point.bytes, lambda p: p.bytes)


def picture(path):
    """RGB in [0, 1], enlarged without smoothing; None where there is none."""
    try:
        values = matplotlib.image.imread(path)[..., :3]
    except (OSError, SyntaxError, ValueError, IndexError):
        return None
    return np.kron(values, np.ones((SCALE, SCALE, 1)))


def pictures_of(folder, point):
    """(picture, FLIP map) of the first seed."""
    answers = Path(folder) / point.run.rows[0]["answers"]
    size = answers.stem.rsplit("-", 1)[0]
    return picture(answers.with_name(f"{size}.png")), picture(answers.with_name(f"{size}-flip.png"))


def words_of(point):
    flip = "" if point.run.flip is None else f", FLIP {number_text(point.run.flip)}"
    return (
        f"{hits_text(point.hits)} hits, {seconds_text(point.seconds)}, {bytes_text(point.bytes)}\n"
        f"RMS {percent_text(point.split.error)}{flip}"
    )


def two_lines(name):
    """A long name is cut at the slash nearest to its middle."""
    cuts = [i for i, c in enumerate(name) if c == "/"]
    middle = min(cuts, key=lambda i: abs(i - len(name) / 2))
    return name if len(name) < 24 else f"{name[: middle + 1]}\n{name[middle + 1 :]}"


def show(axes, values, missing):
    axes.set_axis_off()
    if values is None:
        axes.text(0.5, 0.5, missing, transform=axes.transAxes, ha="center", va="center", fontsize=8)
    else:
        axes.imshow(values, interpolation="nearest", aspect="auto")


def picture_row(study, scene, curves, names, budget, title, words):
    """`names`: the methods beside the reference."""
    names = [n for n in names if n in curves]
    reference = picture(study.folder / study.scene_folder(scene.name) / "reference.png")
    height, width = (72 * SCALE, 128 * SCALE) if reference is None else reference.shape[:2]
    caption = (
        f"Each method's largest run within the {budget.text} (up to {100 * (TOLERANCE - 1):.0f} % over). "
        "Sizes are a decade apart: a method may be far below the budget. First seed's picture and FLIP, one exposure; "
        "below: HDR-FLIP against the reference; RMS over all seeds, times are medians. " + words
    )
    sheet = Sheet(
        2, 1 + len(names), (width / DPI, height / DPI), f"{scene.name}: {title}", caption, gap=0.06, foot=0.15
    )
    top, below = sheet.panels
    show(top[0], reference, "no picture")
    top[0].set_title("reference", fontsize=8)
    show(below[0], None, f"the reference's own\nRMS error: {percent_text(scene.reference_error_sq)}")
    for column, name in enumerate(names, 1):
        point = budget.largest_within(curves[name])
        seen, flip = pictures_of(study.folder, point) if point else (None, None)
        show(top[column], seen, "no picture" if point else "no run within the budget")
        show(below[column], flip, "no FLIP map" if point else "")
        top[column].set_title(two_lines(curves[name].method.label), fontsize=7)
        if point:
            below[column].set_title(words_of(point), fontsize=7)
    return sheet


def picture_rows(study, curves_by_scene, names, words):
    """Yields (file name without ending, title, sheet)."""
    for name, curves in curves_by_scene.items():
        for kind, budget in (("time", same_time(curves)), ("bytes", same_bytes(curves))):
            if budget:
                title = f"within the same {kind}"
                yield f"{name}-same-{kind}", title, picture_row(
                    study, study.scenes[name], curves, names, budget, title, words
                )
