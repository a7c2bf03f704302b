"""matplotlib's SVG, taken apart: what has an id of ours is kept, with numbers of two decimals and without what CSS says better.

matplotlib draws and places everything; the page needs its points, lines and axes as pieces that a script can move.
"""

import io
import re
import xml.etree.ElementTree as ElementTree

import matplotlib
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from report.page.markup import Markup, joined, tag

SVG, XLINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}"
POINTS_PER_INCH = 72  # one unit of matplotlib's SVG is a point


def figure_of(width, height, left, right, top, bottom):
    """One pair of axes, all in units of the SVG."""
    figure = Figure(figsize=(width / POINTS_PER_INCH, height / POINTS_PER_INCH))
    FigureCanvasSVG(figure)
    figure.patch.set_visible(False)
    axes = figure.add_axes([left / width, bottom / height, 1 - (left + right) / width, 1 - (top + bottom) / height])
    axes.patch.set_visible(False)
    return figure, axes


def tree_of(figure, salt="page"):
    buffer = io.StringIO()
    with matplotlib.rc_context({"svg.fonttype": "none", "svg.hashsalt": salt, "path.simplify": False}):
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    return ElementTree.fromstring(buffer.getvalue())


def short(text):
    """Numbers with two decimals at most."""
    return re.sub(r"-?\d+\.\d+", lambda m: f"{float(m.group()):.2f}".rstrip("0").rstrip("."), " ".join(text.split()))


def style_of(element):
    pairs = (part.split(":", 1) for part in element.get("style", "").split(";") if ":" in part)
    return {name.strip(): value.strip() for name, value in pairs}


def style_text(style):
    return short("; ".join(f"{name}: {value}" for name, value in style.items()))


def by_id(tree, identity):
    return next((e for e in tree.iter() if e.get("id") == identity), None)


class Markers:
    """The shapes of markers, each once for the whole page."""

    def __init__(self):
        self._found = {}

    def collect(self, tree):
        for defs in tree.iter(f"{SVG}defs"):
            for path in defs.iter(f"{SVG}path"):
                if identity := path.get("id"):
                    self._found.setdefault(identity, tag("path", id=identity, d=short(path.get("d")), style=style_text(style_of(path))))

    def markup(self):
        return Markup("".join(self._found.values()))


def uses(group):
    """[(shape, x, y, style)] of the markers in a group."""
    return [
        (e.get(f"{XLINK}href"), short(e.get("x")), short(e.get("y")), style_text(style_of(e)))
        for e in group.iter(f"{SVG}use")
    ]


def first_path(group):
    """(d, style) of a group's line, None without one; its clip path is left out."""
    path = next(group.iter(f"{SVG}path"), None)
    return None if path is None else (short(path.get("d")), style_text(style_of(path)))


def text_markup(element):
    style = style_of(element)
    anchor = style.get("text-anchor") or element.get("text-anchor")
    transform = element.get("transform")
    turned = short(transform) if transform and not transform.startswith(("rotate(-0", "rotate(0")) else None
    x, y = element.get("x"), element.get("y")
    return tag("text", "".join(element.itertext()), x=x and short(x), y=y and short(y), text_anchor=anchor, transform=turned)


def axis_markup(tree, number, identity):
    """Grid lines and words of one axis (1: x, 2: y) as a group; ticks have no marks."""
    group = by_id(tree, f"matplotlib.axis_{number}")
    lines = [tag("path", d=short(p.get("d"))) for p in group.iter(f"{SVG}path") if p.get("id") is None]
    return tag("g", *lines, *(text_markup(t) for t in group.iter(f"{SVG}text")), id=identity, cls="axis")


KEPT_ATTRIBUTES = ("d", "x", "y", "transform")


def whole(figure, label, titles):
    """The figure as it is, for charts that nothing moves. `titles`: id of a group -> what hovering says of it."""
    tree = tree_of(figure, salt=label)
    width, height = (POINTS_PER_INCH * size for size in figure.get_size_inches())
    inner = joined(element_markup(child, titles) for child in tree)
    return tag("svg", inner, viewBox=f"0 0 {width:.0f} {height:.0f}", cls="panel", role="group", aria_label=label)


def element_markup(element, titles):
    name = element.tag.removeprefix(SVG)
    if name not in ("g", "path", "use", "text", "defs"):
        return None
    if name == "text":
        return text_markup(element)
    identity = element.get("id")
    kept = {key: short(element.get(key)) for key in KEPT_ATTRIBUTES if element.get(key)}
    is_grid = name == "path" and "b0b0b0" in element.get("style", "")
    drawn = {"cls": "grid"} if is_grid else {"style": style_text(style_of(element)) or None}
    if identity in titles:
        return tag("g", tag("title", titles[identity]), *(element_markup(c, titles) for c in element), id=identity, cls="mark", tabindex="0", role="img")
    is_shape = name == "path" and identity
    return tag(name, *(element_markup(c, titles) for c in element), id=identity if is_shape else None, href=element.get(f"{XLINK}href"), **kept, **drawn)
