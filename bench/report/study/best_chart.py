"""The least error that light maps and photon maps have within a time: the study in one picture."""

import numpy as np
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from report.sheet import Sheet, log_log
from report.study.first import of_kind
from report.study.front import all_points, pareto_front

PANEL = (2.35, 2.5)  # inches
KINDS = (  # name, whether of photon maps, style
    ("best light map", False, {"color": "#c05621", "linestyle": "-", "marker": "^"}),
    ("best photon map", True, {"color": "#2b6cb0", "linestyle": "--", "marker": "o"}),
)
NOTE = (
    "Each point is a run that no other of its kind beats in both time and error. Time: trace, insert, build, and all answers, less "
    "what is done once for a scene. Error: relative root mean square. "
)
TICKS = (1, 2, 5, 10, 20, 50, 100)
TOP = 120


def front_of_kind(curves, photon_maps):
    return pareto_front(all_points(of_kind(curves, photon_maps)), lambda p: p.seconds)


def draw_scene(axes, curves):
    for name, photon_maps, style in KINDS:
        front = front_of_kind(curves, photon_maps)
        axes.plot([p.seconds for p in front], [100 * np.sqrt(p.split.error) for p in front], markersize=4.5, linewidth=1.6, label=name, **style)


def share_axes(panels):
    """Errors above TOP are left out: nobody asks for such a map."""
    left, right = zip(*(axes.get_xlim() for axes in panels))
    least = min(axes.get_ylim()[0] for axes in panels)
    for axes in panels:
        axes.set_xlim(min(left), max(right))
        axes.set_ylim(least, TOP)
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.set_major_locator(FixedLocator(TICKS))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g} %"))


def best_against_time(curves_by_scene, title, words):
    """One row, with the same axes for all scenes."""
    sheet = Sheet(1, len(curves_by_scene), PANEL, title, NOTE + words, gap=0.15, legend_lines=1)
    for column, (scene, curves) in enumerate(curves_by_scene.items()):
        axes = sheet.panels[0][column]
        draw_scene(axes, curves)
        log_log(axes, scene, "seconds", "error" if column == 0 else "")
        axes.tick_params(labelleft=column == 0)
        axes.yaxis.set_minor_locator(NullLocator())
    share_axes(sheet.panels[0])
    sheet.legend(len(KINDS))
    return sheet
