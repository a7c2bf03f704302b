"""Draws the charts of one comparison: bench/report compare FOLDER, where FOLDER has compare.json. Writes FOLDER/charts/*.png."""


import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from report.compare.baselines import BYTES, GATHER_US, INSERT_NS, one_per_engine, sum_of
from report.compare.comparison import Comparison, map_seconds
from report.compare.memory_wall import growth, peaks, wall_bytes
from report.sheet import save_chart
from report.text import bytes_text

BILLION = 1e9
SHUFFLED_GATHER_US, BYTES_WHILE_FILLED = sum_of(("gather_us_per_query_shuffled",)), sum_of(("insert_bytes",))


def style_of(comparison, method):
    _, style = comparison.facts(method)
    return {"color": style["colour"], "marker": style["marker"]}


def styles(comparison):
    """The methods that are drawn, in the order of the table: one photon map for each engine, and the light map."""
    drawn = [*one_per_engine(comparison), *(m for m in comparison.methods if m == comparison.light_map)]
    return {method: style_of(comparison, method) for method in drawn}


def draw_line(axes, rows, figure, style, label, line="-"):
    """Medians joined by a line, with the range over the repetitions as a band."""
    hits = [row["hits"] for row in rows]
    lows, highs = zip(*(figure.bounds(row) for row in rows))
    axes.plot(hits, [figure.value(row) for row in rows], line, label=label, markersize=4, linewidth=1.3, **style)
    axes.fill_between(hits, lows, highs, color=style["color"], alpha=0.15)


def caption(comparison):
    context = comparison.context
    repetitions = sorted({row["repetitions"] for row in comparison.rows if "skipped" not in row}) or [0]
    count = f"{repetitions[0]}" if len(repetitions) == 1 else f"{repetitions[0]} to {repetitions[-1]}"
    return (
        f"medians of {count} interleaved runs, bands: smallest to largest; {context['threads']} threads, seed {context['seed']}, "
        f"{context['settings']}\n{context['machine']}, {context['compiler']}, Embree {context['libraries']['embree']}, "
        f"FLANN {context['libraries']['flann']}, commit {context['commit']}"
    )


def chart(comparison, name, title, unit, draw):
    """One panel per scene, same axes; `draw(axes, scene)` fills a panel."""
    scenes = comparison.scenes
    figure, panels = plt.subplots(1, len(scenes), figsize=(max(7.0, 1.2 + 3.4 * len(scenes)), 4.6), sharey=True, squeeze=False)
    for axes, scene in zip(panels[0], scenes):
        draw(axes, scene)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(scene)
        axes.set_xlabel("hits")
        axes.grid(True, which="major", linewidth=0.4, alpha=0.6)
    panels[0][0].set_ylabel(unit)
    figure.suptitle(title)
    figure.text(0.01, 0.005, caption(comparison), fontsize=5.5, color="#444444", va="bottom")
    by_label = {label: handle for axes in panels[0] for handle, label in zip(*axes.get_legend_handles_labels())}
    label_inches = 0.5 + 0.055 * max(map(len, by_label), default=0)
    columns = max(1, min(len(by_label), int(figure.get_size_inches()[0] / label_inches)))
    rows = -(-len(by_label) // columns)
    below = (0.42 + 0.16 * rows) / figure.get_size_inches()[1]
    figure.legend(by_label.values(), by_label.keys(), loc="lower center", bbox_to_anchor=(0.5, 0.055), ncol=columns, fontsize=7)
    figure.tight_layout(rect=(0, below, 1, 1))
    save_chart(figure, comparison.folder / "charts" / f"{name}.png")


def draw_methods(comparison, figure):
    def draw(axes, scene):
        for method, style in styles(comparison).items():
            if rows := comparison.series(scene, method):
                draw_line(axes, rows, figure, style, method)

    return draw


def draw_gather(comparison):
    def draw(axes, scene):
        for method, style in styles(comparison).items():
            if rows := comparison.series(scene, method):
                draw_line(axes, rows, GATHER_US, style, method)
                draw_line(axes, rows, SHUFFLED_GATHER_US, style, None, "--")

    return draw


def draw_bytes(comparison):
    def draw(axes, scene):
        for method, style in styles(comparison).items():
            if rows := comparison.series(scene, method):
                draw_line(axes, rows, BYTES, style, method)
        light_map = comparison.light_map
        if rows := comparison.series(scene, light_map):
            draw_line(axes, rows, BYTES_WHILE_FILLED, style_of(comparison, light_map), f"{light_map}, while tracing", "--")

    return draw


def longest_series(comparison, scene):
    return max((comparison.series(scene, method) for method in styles(comparison)), key=len, default=[])


def draw_beyond(axes, grows, style, wall):
    """From the last measured row in a straight line to a billion hits, with what that would take; a cross where it meets the wall."""
    last = grows.rows[-1]
    if last["hits"] >= BILLION:
        return
    steps = [last["hits"] * (BILLION / last["hits"]) ** (i / 40) for i in range(41)]
    axes.plot(steps, [grows.bytes_at(h) for h in steps], "--", color=style["color"], linewidth=1.0)
    at_wall = grows.hits_at(wall) if wall else None
    if at_wall and at_wall <= BILLION:
        axes.plot([at_wall], [wall], "x", color=style["color"], markersize=7)


def label_ends(axes, ends):
    """Each method's bytes at a billion hits, beside the right edge and not on top of each other; `ends`: (bytes, text, colour)."""
    least = 0.0
    for size, text, color in sorted(ends):
        place = max(size, least)
        least = place * 1.9
        axes.text(1.02, place, text, transform=axes.get_yaxis_transform(), color=color, fontsize=6.5, va="center")
    axes.set_ylim(top=max(axes.get_ylim()[1], 2 * least))


def draw_memory_wall(comparison):
    def draw(axes, scene):
        wall, ends = wall_bytes(comparison, scene), []
        for method, style in styles(comparison).items():
            if rows := peaks(comparison, scene, method):
                axes.plot([r["hits"] for r in rows], [r["peak_growth_bytes"] for r in rows], label=method, markersize=4, linewidth=1.3, **style)
            if grows := growth(comparison, scene, method):
                draw_beyond(axes, grows, style, wall)
                measured = grows.rows[-1]["hits"] >= BILLION
                ends.append((grows.bytes_at(BILLION), ("" if measured else "\u2248 ") + bytes_text(grows.bytes_at(BILLION)), style["color"]))
        if wall:
            axes.axhline(wall, color="#a01010", linewidth=1.4, label="--max-memory")
            axes.text(0.02, wall * 1.15, f"the wall: {bytes_text(wall)}", transform=axes.get_yaxis_transform(), color="#a01010", fontsize=7)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlim(right=BILLION * 1.3)
        label_ends(axes, ends)

    return draw


def draw_time_to_map(comparison):
    def draw(axes, scene):
        for method, style in styles(comparison).items():
            if rows := comparison.series(scene, method):
                axes.plot([r["hits"] for r in rows], [map_seconds(r) for r in rows], label=method, markersize=4, **style)
        if rows := longest_series(comparison, scene):
            axes.plot([r["hits"] for r in rows], [r["trace_seconds"] for r in rows], ":", color="#555555", label="trace alone")

    return draw


def main(arguments):
    comparison = Comparison(arguments[0])
    chart(comparison, "insert", "Inserting a hit into the store", "ns per hit and thread", draw_methods(comparison, INSERT_NS))
    chart(comparison, "gather", "Irradiance at a visible point, one thread; dashed: points shuffled", "µs per query", draw_gather(comparison))
    chart(comparison, "bytes", "Memory of the map with its index", "bytes", draw_bytes(comparison))
    chart(comparison, "memory-wall", "Memory added to the process; dashed: drawn on to a billion hits", "bytes", draw_memory_wall(comparison))
    chart(comparison, "time-to-map", "From nothing to a map that answers", "s: empty store, trace, insert, build", draw_time_to_map(comparison))
