"""What an error and a time consist of: bias and variance, error by tilt, the four phases."""

import math

from report.sheet import SMALL, Sheet, log_log, percent_axis, plain_axes
from report.study.charts import chosen, draw_bars
from report.study.data import PHASES
from report.study.methods import REFERENCE_PHOTON_MAP, label_of
from report.text import hits_text, seconds_text

NOTE_LOST = (
    "Bars: bands; a triangle without a line: bias² at or below zero, drawn at the upper end of its band."
)
VARIANCE_COLOUR, BIAS_COLOUR = "#2b6cb0", "#c53030"
PHASE_COLOURS = {"trace": "#9aa5b1", "insert": "#e6a117", "build": "#2f9e77", "gather": "#3b6fd4"}
TILT_PARTS = {
    "error": lambda s: (s.error, s.error_band),
    "bias² alone": lambda s: (s.bias_sq, s.bias_sq_band),
    "variance alone": lambda s: (s.variance, s.variance_band),
}


def draw_split(axes, curve):
    hits = curve.array("hits")
    several = [p.split for p in curve.points]
    variance = {"color": VARIANCE_COLOUR, "marker": "o", "linestyle": "-"}
    bias = {"color": BIAS_COLOUR, "marker": "s", "linestyle": "--", "markerfacecolor": "white"}
    draw_bars(
        axes, hits, [s.variance for s in several], [s.variance_band for s in several], variance, "variance"
    )
    draw_bars(axes, hits, [s.bias_sq for s in several], [s.bias_sq_band for s in several], bias, "bias²")


def split_limits(study, curves_by_scene, names):
    """The same for all panels; what is far below the reference's own error is of no interest."""
    values = [
        max(value, 0.1 * study.scenes[scene].reference_error_sq)
        for scene, curves in curves_by_scene.items()
        for c in chosen(curves, names)
        for p in c.points
        for value in (p.split.variance, p.split.bias_sq)
        if value > 0
    ]
    return (min(values) / 2.5, max(values) * 2.5) if values else (1e-6, 1)


def bias_and_variance(study, curves_by_scene, names, title, words):
    """A row per method, a column per scene; the same axes everywhere."""
    names = [n for n in names if any(n in curves for curves in curves_by_scene.values())]
    caption = f"{NOTE_LOST} Dotted: the reference's own v_R. Sizes of a single seed cannot be split. " + words
    shape = (len(names), len(curves_by_scene))
    sheet = Sheet(*shape, (2.6, 1.4), title, caption, gap=0.25, foot=0.4, legend_lines=1, head=0.35)
    limits = split_limits(study, curves_by_scene, names)
    for column, (scene, curves) in enumerate(curves_by_scene.items()):
        for row, method in enumerate(names):
            axes = sheet.panels[row][column]
            if method in curves:
                draw_split(axes, curves[method])
            axes.axhline(
                study.scenes[scene].reference_error_sq, linestyle=":", color="#333333", linewidth=0.8
            )
            log_log(
                axes,
                "",
                "hits" if row == len(names) - 1 else "",
                "relative mean square" if column == 0 else "",
            )
            axes.set_ylim(*limits)
            axes.set_xlim(*hits_limits(curves_by_scene))
            axes.tick_params(labelleft=column == 0)
            axes.minorticks_off()
            if column == 0:
                axes.set_title(
                    label_of(method),
                    fontsize=8,
                    loc="left",
                    fontweight="bold",
                )
        top = sheet.panels[0][column]
        top.annotate(
            scene,
            (0.5, 1),
            xytext=(0, 22),
            xycoords="axes fraction",
            textcoords="offset points",
            ha="center",
            fontsize=10,
        )
    sheet.legend(2)
    return sheet


def hits_limits(curves_by_scene):
    hits = [p.hits for curves in curves_by_scene.values() for c in curves.values() for p in c.points]
    return min(hits) / 1.6, max(hits) * 1.6


def time_sizes(curves):
    """1e6 hits, or the nearest size to it, and the largest size."""
    sizes = sorted({p.run.hits_asked for c in curves for p in c.points})
    return list(dict.fromkeys([min(sizes, key=lambda h: abs(math.log(h / 1e6))), sizes[-1]])) if sizes else []


def draw_phases(axes, points, names):
    """A bar per method, in the order of `names` from the top; methods without this size leave a gap."""
    by_name = {p.run.method: p for p in points}
    for row, name in enumerate(names):
        if name not in by_name:
            continue
        left = 0.0
        for phase in PHASES:
            seconds = by_name[name].run.median(phase + "_seconds")
            axes.barh(row, seconds, left=left, height=0.72, color=PHASE_COLOURS[phase], label=phase)
            left += seconds
        axes.text(left, row, " " + seconds_text(left), va="center", fontsize=SMALL)
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.margins(x=0.2)


def time_split(curves_by_scene, names, title, words):
    """A row per scene; a column for each of two sizes."""
    kept = {name: curve.method.engine != "" for curves in curves_by_scene.values() for name, curve in curves.items()}
    names = sorted(set(names), key=lambda n: (kept.get(n, False), names.index(n)))
    caption = (
        "Medians over the seeds of each phase, wall time; all methods of one seed are fed from one trace. "
        + words
    )
    shape = (2.9, 0.17 * len(names) + 0.25)
    sheet = Sheet(len(curves_by_scene), 2, shape, title, caption, gap=0.35, legend_lines=1, left=2.0)
    for row, (scene, curves) in enumerate(curves_by_scene.items()):
        sizes = time_sizes(chosen(curves, names))
        for column, axes in enumerate(sheet.panels[row]):
            if column >= len(sizes):
                axes.remove()
                continue
            points = [p for c in chosen(curves, names) for p in c.points if p.run.hits_asked == sizes[column]]
            draw_phases(axes, points, names)
            plain_axes(axes, f"{scene}, {hits_text(sizes[column])} hits", "s", "")
            axes.set_yticks(
                range(len(names)),
                [label_of(n) for n in names] if column == 0 else [],
            )
            axes.grid(True, axis="x", linewidth=0.4, alpha=0.6)
    sheet.legend(len(PHASES))
    return sheet


def tilt_methods(curves):
    """Those measured of: a light map per order with the same gather, and the photon map."""
    wanted = ["shlm/L0/normalised/{}", "shlm/F1/radiance/{}", "shlm/L2/radiance/{}", "shlm/L4/radiance/{}"]
    found = {g: [w.format(g) for w in wanted if w.format(g) in curves] for g in ("surface4", "bilinear", "own")}
    gather = max(found, key=lambda g: len(found[g]))
    return found[gather] + [n for n in (REFERENCE_PHOTON_MAP,) if n in curves]


def common_size(curves):
    """The largest size that most of the curves have with two seeds or more; None where there is none."""
    sizes = [p.run.hits_asked for c in curves for p in c.points if p.split.seed_count > 1]
    return max(set(sizes), key=lambda size: (sizes.count(size), size)) if sizes else None


def tilted_scenes(curves_by_scene):
    return [
        n for n, curves in curves_by_scene.items() if any(p.tilted for c in curves.values() for p in c.points)
    ]


def error_by_tilt(curves_by_scene, styles, title, words):
    """None where no scene has normal maps. A row per such scene; all of the error, bias, noise."""
    scenes = tilted_scenes(curves_by_scene)
    if not scenes:
        return None
    caption = (
        "Points binned by the angle between shading and geometric normal, at the largest size that most of the "
        f"methods have two seeds of. {NOTE_LOST} Same axis in a row; right: relative RMS. " + words
    )
    sheet = Sheet(
        len(scenes), len(TILT_PARTS), (2.9, 2.8), title, caption, gap=0.55, foot=0.65, legend_lines=2
    )
    for row, name in enumerate(scenes):
        curves = chosen(curves_by_scene[name], tilt_methods(curves_by_scene[name]))
        draw_tilt_row(sheet.panels[row], name, curves, styles)
    sheet.legend(3)
    return sheet


def tilt_middle(tilted):
    """Degrees; the last bin is drawn as wide as the others."""
    return 0.5 * (tilted.low + min(tilted.high, tilted.low + 10))


def draw_tilt_row(panels, scene, curves, styles):
    size = common_size(curves)
    if size is None:
        for axes in panels:
            axes.remove()
        return
    points = [(c, p) for c in curves for p in c.points if p.run.hits_asked == size and p.split.seed_count > 1]
    values = []
    for axes, (part, value_of) in zip(panels, TILT_PARTS.items()):
        for place, (curve, point) in enumerate(points):
            found = [value_of(t.split) for t in point.tilted]
            values += [v for v, _ in found if v > 0]
            beside = 1.2 * (place - 0.5 * (len(points) - 1))  # degrees, so that bars do not hide each other
            middle = [tilt_middle(t) + beside for t in point.tilted]
            draw_bars(
                axes,
                middle,
                [v for v, _ in found],
                [b for _, b in found],
                styles.of(curve.method),
                curve.method.label,
            )
        axes.set_yscale("log")
        plain_axes(axes, f"{scene}, {hits_text(size)} hits: {part}", "degrees (points in the bin)", "")
        bins = points[0][1].tilted
        axes.set_xticks(
            [tilt_middle(t) for t in bins], [f"{t.label}\n({t.points})" for t in bins], fontsize=SMALL
        )
        axes.grid(True, which="major", linewidth=0.4, alpha=0.6)
    least = 1e-2 * min(t.split.error for _, p in points for t in p.tilted if t.split.error > 0)
    for axes in panels:
        axes.set_ylim(max(min(values), least) / 2, max(values) * 2)
    panels[0].set_ylabel("relative mean square", fontsize=8)
    percent_axis(panels[-1])
