"""Draws the study's panels with matplotlib: error over time, with an id for every point and series.

The other fifteen pairs of axes show the same points elsewhere. They are not drawn here sixteen times (4 MB): matplotlib draws each
of the eight axes once, and the script moves points, lines and bands along them. Without the script the page shows error over time.
"""

import math

from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from report.page import svg
from report.page.markup import Markup, joined, tag
from report.page.quantities import COSTS, ERRORS, Scales
from report.page.theory import fronts, ghosts
from report.study.methods import LIGHT_MAP
from report.study.styles import Styles

COST, ERROR = COSTS[0], ERRORS[0]  # of the chart that needs no script
FONT = 11


class PageStyles:
    """The study's colours and dashes. Shapes tell methods apart without colour: filled are light maps, by basis, larger for more texels; hollow are
    photon maps, by how they choose photons, larger for more photons or a larger radius."""

    SIZES, SIZE, EDGE = (4.5, 9.5), 7, 1.4

    def __init__(self, study):
        kinds = study.kinds.values()
        self._study, self._styles = study, Styles([kind.method for kind in kinds])
        self._amounts = {kind.method.family: sorted({amount(k) for k in kinds if k.method.family == kind.method.family and amount(k)}) for kind in kinds}

    def _size(self, kind):
        amounts = self._amounts[kind.method.family]
        if not amount(kind) or len(amounts) < 2:
            return self.SIZE
        least, most = math.log(amounts[0]), math.log(amounts[-1])
        return self.SIZES[0] + (self.SIZES[1] - self.SIZES[0]) * (math.log(amount(kind)) - least) / (most - least)

    def of(self, name):
        kind = self._study.kinds[name]
        style = {"fillstyle": "full", **self._styles.of(kind.method), "markersize": self._size(kind), "markeredgewidth": self.EDGE}
        if self._study.family(name) == LIGHT_MAP:
            return style | {"marker": kind.method.marker}
        return style | {"fillstyle": "none"}


def amount(kind):
    """Texels of a light map; k, its factor or the radius of a photon map."""
    return kind.texels or kind.method.number


def new_axes(scales, cost, error):
    figure, axes = svg.figure_of(scales.WIDTH, scales.HEIGHT, scales.LEFT, scales.RIGHT, scales.TOP, scales.BOTTOM)
    for axis, set_scale, set_limits, quantity in (
        (axes.xaxis, axes.set_xscale, axes.set_xlim, cost),
        (axes.yaxis, axes.set_yscale, axes.set_ylim, error),
    ):
        low, high = scales.limits[quantity.key]
        set_scale("log")
        set_limits(low, high)
        axis.set_major_locator(FixedLocator(scales.ticks(quantity)))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _, text=quantity.text: text(value)))
        axis.set_label_text(quantity.label, fontsize=FONT)
        axis.labelpad = 8
    axes.tick_params(length=0, labelsize=FONT, pad=5)
    axes.grid(True)
    return figure, axes


def axes_markup(scales):
    """All eight: four figures have one of each kind."""
    made = []
    for cost, error in zip(COSTS, ERRORS):
        tree = svg.tree_of(new_axes(scales, cost, error)[0])
        made += [svg.axis_markup(tree, 1, f"axis-{cost.key}"), svg.axis_markup(tree, 2, f"axis-{error.key}")]
    return joined(made)


def plot_series(axes, scales, rows, style):
    """One method in one scene: bands, a line, and each point by itself, so that each has its id."""
    places = [(scales.clamped(COST, COST.of(r)), scales.clamped(ERROR, ERROR.of(r))) for r in rows]
    for row in rows:
        if band := ERROR.band(row):
            ends = [scales.clamped(ERROR, end) for end in band]
            axes.plot([COST.of(row)] * 2, ends, color=style["color"], linewidth=1, clip_on=False, gid=f"b{row.number}")
    line = {key: style[key] for key in ("color", "linestyle")}
    axes.plot(*zip(*places), **line, linewidth=1.4, clip_on=False, gid=f"l{rows[0].number}")
    marker = {key: style[key] for key in ("color", "marker", "fillstyle", "markersize", "markeredgewidth")}
    for row, place in zip(rows, places):
        axes.plot(*[[v] for v in place], **marker, linestyle="none", clip_on=False, gid=f"p{row.number}")


def point_markup(tree, row, name):
    drawn = svg.uses(svg.by_id(tree, f"p{row.number}"))
    shapes = joined(tag("use", href=shape, x=x, y=y, style=style) for shape, x, y, style in drawn)
    return tag("g", tag("title", name), shapes, id=f"p{row.number}", cls="point", tabindex="-1", role="img")


def path_markup(found, **attributes):
    return tag("path", d=found[0], style=found[1], **attributes) if found else None


def row_name(row):
    """In full, with its figures: what hovering and screen readers say."""
    return (
        f"{row.method}, {row.scene}, {COSTS[3].text(row.hits)} hits: error {ERROR.text(row.error)}, "
        f"{COST.text(row.seconds)}, {COSTS[1].text(row.bytes)}"
    )


def series_markup(tree, rows, number, is_bright):
    bands = [path_markup(svg.first_path(group), id=f"b{r.number}", cls="band") for r in rows if (group := svg.by_id(tree, f"b{r.number}")) is not None]
    line = path_markup(svg.first_path(svg.by_id(tree, f"l{rows[0].number}")), id=f"l{rows[0].number}", cls="line")
    points = [point_markup(tree, row, row_name(row)) for row in rows]
    return tag("g", *bands, line, *points, cls="series" if is_bright else "series dim", data_method=number)


def front_path(scales, study, scene, numbers):
    """A staircase: an error stays until a dearer run betters it."""
    figure, axes = new_axes(scales, COST, ERROR)
    places = [(COST.of(study.rows[n]), scales.clamped(ERROR, ERROR.of(study.rows[n]))) for n in numbers]
    if places:
        axes.step(*zip(*places), where="post", clip_on=False, gid="front")
    group = svg.by_id(svg.tree_of(figure), "front")
    return svg.first_path(group)[0] if group is not None else ""


def ghost_paths(scales, lines):
    figure, axes = new_axes(scales, COST, ERROR)
    for number, ghost in enumerate(lines):
        axes.plot(*zip(*ghost["line"]), gid=f"ghost{number}")
    tree = svg.tree_of(figure)
    return [svg.first_path(svg.by_id(tree, f"ghost{number}"))[0] for number in range(len(lines))]


class Charts:
    """All panels of one study and what they share."""

    def __init__(self, study):
        self.study, self.scales, self.markers = study, Scales(study), svg.Markers()
        self.names = list(dict.fromkeys(row.method for row in study.rows))
        self.bright = study.best_known or self.names
        self.fronts = fronts(study)
        self.ghosts = {scene: ghosts(study, scene) for scene in study.scenes}
        self._styles = PageStyles(study)
        self._swatches = {}

    def series(self, scene):
        """name -> rows in ascending order of hits; dim ones first, so that bright ones lie above them."""
        rows = [r for r in self.study.rows if r.scene == scene and r.error is not None]
        names = sorted({r.method for r in rows}, key=lambda name: (name in self.bright, self.names.index(name)))
        return {name: sorted((r for r in rows if r.method == name), key=lambda r: r.hits) for name in names}

    def panel(self, scene):
        scales, series = self.scales, self.series(scene)
        figure, axes = new_axes(scales, COST, ERROR)
        for name, rows in series.items():
            plot_series(axes, scales, rows, self._styles.of(name))
        tree = svg.tree_of(figure)
        self.markers.collect(tree)
        groups = [series_markup(tree, rows, self.names.index(name), name in self.bright) for name, rows in series.items()]
        for name, group in zip(series, groups):
            self._swatches.setdefault(name, swatch(tree, series[name]))
        lines = self.ghosts[scene][COST.key]
        clip = f"clip-{scene}"
        inside = tag("rect", x=scales.LEFT, y=scales.TOP, width=scales.WIDTH - scales.LEFT - scales.RIGHT, height=scales.HEIGHT - scales.TOP - scales.BOTTOM)
        return tag(
            "svg",
            tag("clipPath", inside, id=clip),
            tag("use", href=f"#axis-{COST.key}", cls="x-axis"),
            tag("use", href=f"#axis-{ERROR.key}", cls="y-axis"),
            tag("g", *(tag("path", d=d) for d in ghost_paths(scales, lines)), cls="ghosts", clip_path=f"url(#{clip})"),
            tag("path", d=front_path(scales, self.study, scene, self.fronts[f"{COST.key}/{ERROR.key}"][scene]), cls="front"),
            *groups,
            cls="panel",
            data_scene=scene,
            viewBox=f"0 0 {scales.WIDTH} {scales.HEIGHT}",
            role="group",
            aria_label=f"{scene}: {ERROR.short} over {COST.short}",
        )

    def swatch(self, name):
        return self._swatches.get(name, Markup(""))

    def shared(self):
        """Shapes and axes, once, in an image of no size."""
        return tag("svg", tag("defs", self.markers.markup(), axes_markup(self.scales)), width="0", height="0", cls="shared", aria_hidden="true")


def swatch(tree, rows):
    """A line with the marker on it, for legends."""
    line = svg.first_path(svg.by_id(tree, f"l{rows[0].number}"))
    shapes = [tag("use", href=shape, x="18", y="7", style=style) for shape, _, _, style in svg.uses(svg.by_id(tree, f"p{rows[0].number}"))]
    return tag("svg", tag("path", d="M1 7H35", style=line[1]) if line else None, *shapes, cls="swatch", viewBox="0 0 36 14", aria_hidden="true")
