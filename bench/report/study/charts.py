"""Error against cost, and gather time: one panel per scene, one line per method."""

import numpy as np

from report.sheet import SMALL, Sheet, grid_shape, log_log, percent_axis
from report.study.slopes import FIRST_HITS, VARIANCE_OVER_BIAS
from report.text import number_text

PANEL = (4.9, 3.5)  # inches
ERROR_LABEL = "error (MSE - v_R), dotted: v_R"
NOTE_SINGLE = "Hollow: a single seed. "
NOTE_FRONT = (
    NOTE_SINGLE
    + "Grey steps: Pareto front of all methods of the study, drawn here or not; rings: runs on it. "
)

NOTE_SLOPES = (
    "Slopes in log-log by least squares; ±: half of the 95 % band. "
    f"Sizes fitted: where the variance is at least {VARIANCE_OVER_BIAS:g} x bias² (light maps, fixed radius), "
    f"all from {number_text(FIRST_HITS)} hits on (fixed or growing k). Part of the time and all bytes of a light map do "
    "not grow with the hits. "
)


def draw_line(axes, x, values, bands, style, label, line_width=1.3):
    """Joined values, with their bands; what is not above zero cannot be drawn and leaves a gap."""
    values = np.where(np.asarray(values) > 0, values, np.nan)
    axes.plot(x, values, label=label, markersize=4, linewidth=line_width, **style)
    low = np.array([b[0] if b else np.nan for b in bands], dtype=float)
    high = np.array([b[1] if b else np.nan for b in bands], dtype=float)
    low = np.where(low > 0, low, np.nan_to_num(values, nan=1.0) * 1e-3)
    axes.fill_between(
        x, np.where(np.isfinite(high), low, np.nan), high, color=style["color"], alpha=0.15, linewidth=0
    )


def draw_bars(axes, x, values, bands, style, label):
    """Joined values with bands as bars: of what may be below zero only the part above can be drawn."""
    x, values = np.asarray(x, dtype=float), np.asarray(values, dtype=float)
    seen = np.where(values > 0, values, np.nan)
    axes.plot(x, seen, label=label, markersize=4, linewidth=1.2, **style)
    for at, value, ends in zip(x, values, bands):
        if ends and ends[1] > 0:
            axes.plot(
                [at, at],
                [max(ends[0], ends[1] * 1e-6), ends[1]],
                "-",
                color=style["color"],
                linewidth=0.9,
                alpha=0.8,
                zorder=1,
            )
            if value <= 0:
                axes.plot([at], [ends[1]], "v", color=style["color"], markersize=4.5)


def draw_error(axes, curve, column, styles, label):
    style = styles.of(curve.method)
    draw_line(
        axes, curve.array(column), curve.errors, [p.split.error_band for p in curve.points], style, label
    )
    single = [p for p in curve.points if p.split.seed_count == 1 and p.split.error > 0]
    axes.plot(
        [getattr(p, column) for p in single],
        [p.split.error for p in single],
        style["marker"],
        color=style["color"],
        markerfacecolor="white",
        markersize=4,
    )


def limits_of_values(axes, curves, reference_error_sq):
    """The axis follows the values, not wide bands of few seeds, and v_R where it is near."""
    values = np.concatenate([c.errors for c in curves])
    values = values[values > 0]
    if not len(values):
        return
    low = values.min()
    if 0.1 * low < reference_error_sq:
        low = min(low, reference_error_sq)
    else:
        axes.text(
            0.01,
            0.015,
            f"v_R = {number_text(reference_error_sq, 2)}, below this axis",
            transform=axes.transAxes,
            fontsize=SMALL,
        )
    axes.set_ylim(low / 2.5, values.max() * 2.5)


def draw_front(axes, front, cost_of, drawn):
    """The front as steps, a ring where it is one of the curves drawn."""
    if not front:
        return
    costs, errors = [cost_of(p) for p in front], [p.split.error for p in front]
    axes.step(
        costs,
        errors,
        where="post",
        color="#bbbbbb",
        linewidth=4,
        alpha=0.7,
        zorder=0.5,
        solid_capstyle="butt",
    )
    rings = [p for p in front if p.run.method in drawn]
    axes.plot(
        [cost_of(p) for p in rings],
        [p.split.error for p in rings],
        "o",
        markersize=9,
        markerfacecolor="none",
        markeredgecolor="#555555",
        markeredgewidth=0.8,
        zorder=3,
    )


def chosen(curves, names):
    return [curves[name] for name in names if name in curves]


def finish(axes, scene, curves, title, x_label):
    reference_error_sq = scene.reference_error_sq
    if reference_error_sq > 0:
        axes.axhline(reference_error_sq, linestyle=":", color="#333333", linewidth=1)
    log_log(axes, title, x_label, ERROR_LABEL)
    limits_of_values(axes, curves, reference_error_sq)
    percent_axis(axes)


def legend_shape(names):
    """(columns, lines)"""
    columns = 3
    return columns, -(-len(names) // columns)


def panels_of(sheet, study, curves_by_scene):
    """(axes, scene, its curves); panels without a scene are taken away."""
    flat = list(sheet.panels.flat)
    for axes in flat[len(curves_by_scene) :]:
        axes.remove()
    return [(axes, study.scenes[name], curves) for axes, (name, curves) in zip(flat, curves_by_scene.items())]


def error_against_time(study, curves_by_scene, findings, names, styles, title, words):
    columns = (("over time", lambda f: slope_words(f.over_seconds)), ("theory over hits", theory_words))
    sheet = sheet_with_slopes(curves_by_scene, title, NOTE_FRONT + NOTE_SLOPES + words, len(names))
    for axes, scene, curves in panels_of(sheet, study, curves_by_scene):
        draw_front(axes, findings[scene.name].front_by_time, lambda p: p.seconds, names)
        drawn = chosen(curves, names)
        for curve in drawn:
            draw_error(axes, curve, "seconds", styles, curve.method.label)
        finish(axes, scene, drawn, scene.name, "s until every point is answered: trace + insert + build + gather")
        slope_legend(axes, drawn, findings[scene.name], columns)
    return sheet


def last_points(curves):
    """Of light maps of several sizes the run with the most hits that all have, by bytes."""
    common = set.intersection(*({p.run.hits_asked for p in c.points} for c in curves)) if curves else set()
    points = [p for c in curves for p in c.points if common and p.run.hits_asked == max(common)]
    return sorted(points, key=lambda p: p.bytes)


def draw_texel_curve(axes, curves, names):
    """The light map's own curve over bytes: one texel count after the other at the same hits."""
    points = [p for p in last_points(chosen(curves, names)) if p.split.error > 0]
    if len(points) > 1:
        hits = number_text(points[0].run.hits_asked)
        style = {"color": "#000000", "marker": "*", "linestyle": "-."}
        bands = [p.split.error_band for p in points]
        draw_line(
            axes,
            [p.bytes for p in points],
            [p.split.error for p in points],
            bands,
            style,
            f"shlm/L2/radiance/surface4, texels varied, {hits} hits",
        )


def error_against_bytes(study, curves_by_scene, findings, names, texel_names, styles, title, words):
    columns = (("over bytes", lambda f: slope_words(f.over_bytes)), ("theory over hits", theory_words))
    sheet = sheet_with_slopes(curves_by_scene, title, NOTE_FRONT + NOTE_SLOPES + words, len(names) + 1)
    for axes, scene, curves in panels_of(sheet, study, curves_by_scene):
        draw_front(axes, findings[scene.name].front_by_bytes, lambda p: p.bytes, names)
        drawn = chosen(curves, names)
        for curve in drawn:
            draw_error(axes, curve, "bytes", styles, curve.method.label)
        draw_texel_curve(axes, curves, texel_names)
        finish(axes, scene, chosen(curves, [*names, *texel_names]), scene.name, "bytes of the finished map")
        slope_legend(axes, drawn, findings[scene.name], columns)
    return sheet


def slope_words(slope):
    if slope is None:
        return f"{'-':^14}"
    half = f"±{slope.value - slope.band[0]:.3f}" if slope.band else ""
    return f"{slope.value:+.3f} {half:<7}"


def theory_words(finding):
    return f"{finding.theory_text:<18}"


def slope_legend(axes, curves, finding, columns):
    """A table under the panel: method, then a column per (heading, text of a SlopeFinding); lines without a method
    keep their label."""
    if not curves:
        return
    handles, texts = axes.get_legend_handles_labels()
    width = max(len(c.method.label) for c in curves)
    found = {c.method.label: finding.slopes[c.method.name] for c in curves}
    title = f"{'slope of the error':<{width}}" + "".join(f"  {heading:<14}" for heading, _ in columns)
    labels = [
        f"{text:<{width}}" + "".join(f"  {words(found[text])}" for _, words in columns) if text in found else text
        for text in texts
    ]
    legend = axes.legend(
        handles,
        labels,
        title=" " * 8 + title,
        alignment="left",
        loc="upper left",
        frameon=False,
        bbox_to_anchor=(-0.1, -0.125),
        borderaxespad=0,
        prop={"family": "monospace", "size": SMALL},
        handlelength=3.2,
        labelspacing=0.25,
    )
    legend.get_title().set_fontfamily("monospace")
    legend.get_title().set_fontsize(SMALL)


def sheet_with_slopes(curves_by_scene, title, caption, lines):
    """Room for a table of so many lines under each panel."""
    rows, columns = grid_shape(len(curves_by_scene))
    return Sheet(rows, columns, PANEL, title, caption, gap=1.3, foot=0.55 + 0.13 * (lines + 1))


def error_against_hits(study, curves_by_scene, findings, names, styles, title, words):
    columns = (
        ("over hits", lambda f: slope_words(f.error)),
        ("theory", theory_words),
        ("    of the variance", lambda f: slope_words(f.variance)),
    )
    sheet = sheet_with_slopes(curves_by_scene, title, NOTE_SINGLE + NOTE_SLOPES + words, len(names))
    for axes, scene, curves in panels_of(sheet, study, curves_by_scene):
        drawn = chosen(curves, names)
        for curve in drawn:
            draw_error(axes, curve, "hits", styles, curve.method.label)
        finish(axes, scene, drawn, scene.name, "hits")
        slope_legend(axes, drawn, findings[scene.name], columns)
    return sheet


def gather_against_hits(study, curves_by_scene, names, styles, title, words):
    columns, lines = legend_shape(names)
    caption = (
        "Wall time of the gather of all visible points, all threads, over their number; bands here: smallest to "
        "largest over the seeds. " + words
    )
    sheet = Sheet(*grid_shape(len(curves_by_scene)), PANEL, title, caption, gap=1.0, legend_lines=lines)
    for axes, scene, curves in panels_of(sheet, study, curves_by_scene):
        for curve in chosen(curves, names):
            seconds = [1e6 * p.run.values("gather_seconds") / scene.points for p in curve.points]
            medians, bands = [np.median(s) for s in seconds], [(s.min(), s.max()) for s in seconds]
            draw_line(axes, curve.array("hits"), medians, bands, styles.of(curve.method), curve.method.label)
        log_log(axes, scene.name, "hits", "µs per point")
    sheet.legend(columns)
    return sheet
