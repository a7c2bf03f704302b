"""Error against bytes of the finished map: adaptive light maps, uniform ones by basis, photon maps.

    bench/report model-bytes STUDY OUT

STUDY is the folder of a `shlmbench study`. Writes OUT/model-bytes.png, the largest size of every scene that all have,
and OUT/model-bytes.md: what a uniform light map needs for the error of each adaptive one.
"""

import math
import sys
from pathlib import Path

import numpy as np

from report.front import front_of
from report.markdown import table_text
from report.sheet import SMALL, Sheet, plain_axes
from report.study.curves import curves_of
from report.study.data import Study, StudyError
from report.text import machine_text

ADAPTIVE, PHOTON_MAP = "adaptive", "photon map"
MARKERS = {ADAPTIVE: "*", PHOTON_MAP: "s"}
PHOTON_MAP_COLOUR = "#2f6fb0"  # engines keep the same photons


def kind_of(method):
    """Adaptive, photon map, or the basis of a uniform light map."""
    return PHOTON_MAP if method.engine else method.basis


def colours_of(methods):
    """kind -> colour, adaptive maps first and photon maps last."""
    bases = sorted((m for m in methods if not m.engine), key=lambda m: (m.basis != ADAPTIVE, m.order, m.basis))
    colours = {m.basis: m.colour for m in bases}
    return colours | ({PHOTON_MAP: PHOTON_MAP_COLOUR} if any(m.engine for m in methods) else {})


def at_size(curves, hits):
    """method -> (bytes, error in %) at one number of hits asked for."""
    found = {}
    for curve in curves.values():
        for point in curve.points:
            if point.run.hits_asked == hits:
                found[curve.method] = (point.bytes, 100 * math.sqrt(max(point.split.error, 0)))
    return found


def front(points):
    """Those that nobody with as few bytes beats, from few bytes to many."""
    return front_of(points, lambda p: p[0], lambda p: p[1])


def bytes_for(kept, error):
    """On a straight line in log-log between neighbours of the front; NaN where it does not reach the error."""
    for (small, high), (large, low) in zip([(None, math.inf)] + kept, kept):
        if low > error:
            continue
        if small is None or high == low:
            return large
        along = (math.log(high) - math.log(error)) / (math.log(high) - math.log(low))
        return math.exp(math.log(small) + along * (math.log(large) - math.log(small)))
    return math.nan


def uniform_of(found):
    return {m: point for m, point in found.items() if kind_of(m) not in (ADAPTIVE, PHOTON_MAP)}


def draw(axes, found, title):
    for kind, colour in colours_of(found).items():
        points = sorted(point for method, point in found.items() if kind_of(method) == kind)
        if not points:
            continue
        style = {"color": colour, "label": kind, "markersize": 8 if kind == ADAPTIVE else 4}
        axes.plot(*zip(*points), MARKERS.get(kind, "o"), linestyle="none", **style)
        axes.plot(*zip(*front(points)), color=colour, linewidth=1.3 if kind == ADAPTIVE else 0.6)
    axes.set_xscale("log")
    axes.set_yscale("log")
    plain_axes(axes, title, "bytes of the finished map", "error, %")
    axes.grid(True, which="both", linewidth=0.3, alpha=0.5)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.yaxis.set_minor_formatter(lambda value, _: f"{value:g}" if f"{value:.0e}"[0] in "235" else "")
    axes.tick_params(axis="y", which="minor", labelsize=SMALL)


def largest_size(curves):
    """The largest number of hits that every method was measured with."""
    return max(set.intersection(*({p.run.hits_asked for p in c.points} for c in curves.values())))


def kib(size):
    return "-" if math.isnan(size) else f"{size / 1024:,.0f}"


def ratio(numerator, denominator):
    return "-" if math.isnan(numerator) else f"{numerator / denominator:.1f}"


def short_name(method):
    """a5 by coordinates, a5/face by faces; with its number of texels where that is not the usual one."""
    parts = [f"a{method.number:g}", *(["face"] if method.placement == "face" else []), *([f"t{method.texels}"] if method.texels else [])]
    return "/".join(parts)


def rows_of(scene, hits, found):
    """Cells of each adaptive map that no smaller one beats."""
    kept = front(uniform_of(found).values())
    adaptive_front = front([p for m, p in found.items() if kind_of(m) == ADAPTIVE])
    photon_front = front([p for m, p in found.items() if kind_of(m) == PHOTON_MAP])
    rows = []
    for method, (size, error) in sorted(found.items(), key=lambda item: item[1]):
        if kind_of(method) != ADAPTIVE or (size, error) not in adaptive_front:
            continue
        uniform, photons = bytes_for(kept, error), bytes_for(photon_front, error)
        rows.append((scene, f"{hits:.0e}", short_name(method), f"{error:.2f}", kib(size), kib(uniform), ratio(uniform, size), kib(photons)))
    return rows


HEADS = ("scene", "hits", "adaptive map", "error %", "KiB", "uniform map, KiB", "ratio", "photon map, KiB")


def main(arguments):
    try:
        study = Study(arguments[0])
    except StudyError as error:
        print(error, file=sys.stderr)
        return 2
    out = Path(arguments[1])
    out.mkdir(parents=True, exist_ok=True)
    scenes = curves_of(study)
    seeds = max(row["seed"] for row in study.rows)
    words = (
        "Relative root mean square error at the points that the camera sees (eps: a hundredth of the squared mean), "
        f"root of the mean square over {seeds} seeds, against the path traced reference; all maps have the same photons. "
        "Points: all maps, texels by coordinates and by faces. Lines: those of a kind that no smaller one beats. Uniform texels are halves. "
        + machine_text(study.context)
    )
    columns = 2
    rows = math.ceil(len(scenes) / columns)
    sheet = Sheet(rows, columns, (4.7, 3.6), "Error against bytes of the finished map", words, legend_lines=1)
    panels = list(np.ravel(sheet.panels))
    cells = []
    for axes, (scene, curves) in zip(panels, scenes.items()):
        hits = largest_size(curves)
        found = at_size(curves, hits)
        draw(axes, found, f"{scene}, {hits:.0e} hits")
        cells += rows_of(scene, hits, found)
    for axes in panels[len(scenes) :]:
        axes.set_visible(False)
    sheet.legend(len(colours_of(found)))
    sheet.save(out / "model-bytes.png")
    text = table_text(HEADS, cells)
    (out / "model-bytes.md").write_text(
        text + "\nAdaptive maps that no smaller one beats, by lightmap coordinates and by faces. The uniform map and the photon map are the smallest of the study with at most the same error, "
        "between neighbours on a straight line in log-log; -: none has it.\n"
    )
    print(text, end="")
    for problem in study.problems:
        print(problem, file=sys.stderr)
    return 0
