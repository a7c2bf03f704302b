"""What changes of the program did to times and errors: per machine, ratios against the noise band.

A comparison is head over base. Only what leaves its band is coloured; what a comparison did not run is a gap.
"""

import math

from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from report.page import svg
from report.page.markup import Markup, joined, scrolling, tag
from report.page.words import MISSING, date_text, plural
from report.text import number_text

MISSING_TEXT = MISSING.format("bench/track BASE")
HOW_TO_READ = (
    "Machines are not compared with each other. ▲ is slower or worse and ▼ is faster or better, beyond the noise. "
    "A circle or a plain number is within it; a hatched cell was not run."
)
WORSE, BETTER = ("slower", "worse"), ("faster", "better")
SHAPES = {"up": ("^", "#a33a00"), "down": ("v", "#0b5fa5"), "same": ("o", "#8a8f98")}  # shape beside colour
WIDTH, HEIGHT = 470, 210
COLUMN_TEXT = 10


def side(verdict):
    return "up" if verdict in WORSE else "down" if verdict in BETTER else "same"


def has_ratio(entry):
    return "ratio" in entry and entry["ratio"] and entry["ratio"] > 0


def comparisons(lines):
    """Of two revisions, in order of time; a build compared with itself teaches the bands and is no change."""
    return sorted((line for line in lines if line["kind"] == "two revisions"), key=lambda line: line["date"])


def words_of(line):
    return f"{line['base'][:7]} → {line['head'][:7]}"


def outside(lines, part):
    return [(line, name, e) for line in lines for name, e in line[part].items() if has_ratio(e) and side(e["verdict"]) != "same"]


def limits(lines, part):
    ratios = [e["ratio"] for line in lines for e in line[part].values() if has_ratio(e)]
    farthest = max([abs(math.log(r)) for r in ratios] + [math.log(1.1)])
    return math.exp(-1.15 * farthest), math.exp(1.15 * farthest)


def chart(lines, part, label):
    """A column a comparison, in order of time."""
    figure, axes = svg.figure_of(WIDTH, HEIGHT, 56, 14, 10, 36)
    names = list(dict.fromkeys(name for line in lines for name in line[part]))
    titles = {}
    for column, line in enumerate(lines):
        for place, name in enumerate(names):
            entry = line[part].get(name)
            if not entry or not has_ratio(entry):
                continue
            marker, colour = SHAPES[side(entry["verdict"])]
            x = column + 0.6 * ((place + 0.5) / len(names) - 0.5)
            identity = f"h-{part}-{column}-{place}"
            axes.plot([x], [entry["ratio"]], marker, color=colour, markersize=7, clip_on=False, gid=identity)
            titles[identity] = f"{words_of(line)}, {name}: {cell_text(entry)}, {entry['verdict']}"
    low, high = limits(lines, part)
    axes.set_yscale("log")
    axes.set_ylim(low, high)
    axes.set_xlim(-0.6, len(lines) - 0.4)
    ticks = [t for t in (0.02, 0.05, 0.1, 0.2, 0.5, 0.8, 0.9, 1, 1.1, 1.25, 2, 5, 10, 20, 50) if low <= t <= high]
    axes.yaxis.set_major_locator(FixedLocator(ticks))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: number_text(value)))
    axes.xaxis.set_major_locator(FixedLocator(range(len(lines))))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: date_text(lines[int(value)]["date"])[5:] if 0 <= value < len(lines) else ""))
    axes.tick_params(length=0, labelsize=COLUMN_TEXT)
    axes.set_ylabel(label, fontsize=11)
    axes.grid(True, axis="y")
    return svg.whole(figure, f"{label}, {plural(len(lines), 'comparison')}", titles)


def cell_text(entry):
    if not has_ratio(entry):
        return entry.get("because", entry["verdict"])
    band = f", band ± {100 * (math.exp(entry['band']) - 1):.0f} %" if entry.get("band") else ""
    interval = entry.get("interval")
    span = f" ({number_text(interval[0])} to {number_text(interval[1])}{band})" if interval and None not in interval else ""
    return f"{entry['ratio']:.3f}{span}"


def cell(entry):
    if entry is None:
        return Markup('<td class="gap">')
    sign = {"up": "▲ ", "down": "▼ ", "same": ""}[side(entry["verdict"])]
    text = f"{sign}{entry['ratio']:.2f}" if has_ratio(entry) else entry["verdict"]
    return tag("td", text, cls=side(entry["verdict"]), title=cell_text(entry))


def ratios_table(lines, part):
    names = list(dict.fromkeys(name for line in lines for name in line[part]))
    heads = joined(tag("th", words_of(line), tag("br"), tag("small", date_text(line["date"])), scope="col") for line in lines)
    rows = joined(tag("tr", tag("td", name), *(cell(line[part].get(name)) for line in lines)) for name in names)
    made = tag("table", tag("thead", tag("tr", tag("th", "head over base", scope="col"), heads)), tag("tbody", rows))
    return scrolling(made, f"history of {part}")


def finding(lines):
    slow, fast = ([o for o in outside(lines, "benchmarks") if o[2]["verdict"] in kind] for kind in (WORSE, BETTER))
    worse, better = ([o for o in outside(lines, "errors") if o[2]["verdict"] in kind] for kind in (WORSE, BETTER))
    return (
        f"In {plural(len(lines), 'comparison')} {plural(len(slow), 'time')} left the noise band as slower and {len(fast)} as faster; "
        f"{plural(len(worse), 'error')} became worse and {len(better)} better."
    )


def machine(source):
    lines = comparisons(source.document)
    title = tag("h3", source.file.stem)
    if not lines:
        return joined([title, tag("p", "Only builds compared with themselves, which teach the noise bands.")])
    parts = [part for part in ("benchmarks", "errors") if any(has_ratio(e) for line in lines for e in line[part].values())]
    labels = {"benchmarks": "time, head over base", "errors": "error, head over base"}
    charts = [tag("figure", chart(lines, part, labels[part]), tag("figcaption", labels[part]), cls="chart") for part in parts]
    tables = [tag("details", tag("summary", f"table: {labels[part]}"), ratios_table(lines, part), cls="printed") for part in parts]
    return joined([title, tag("p", finding(lines), cls="finding"), tag("div", *charts, cls="panels"), *tables])


def section(results):
    if not results.histories:
        return tag("p", MISSING_TEXT)
    return joined([tag("p", HOW_TO_READ), *(machine(source) for source in results.histories)])


