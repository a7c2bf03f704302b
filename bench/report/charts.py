"""Draws the charts of one comparison: charts.py FOLDER, where FOLDER has compare.json. Writes FOLDER/charts/*.png."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from comparison import INCREMENTAL, LIGHT_MAP, PHOTON_MAP, Comparison, map_seconds

STYLE = {
    PHOTON_MAP: {"color": "#0b6fb8", "marker": "o"},
    INCREMENTAL: {"color": "#7a5ea8", "marker": "s"},
    LIGHT_MAP: {"color": "#d1542a", "marker": "^"},
}


def value_and_range(row, column):
    value = row[column]
    low, high = row.get(column + "_range", (value, value))
    return value, low, high


def draw_line(axes, rows, column, style, label, line="-"):
    """Medians joined by a line, with the range over the repetitions as a band."""
    hits = [row["hits"] for row in rows]
    values = [value_and_range(row, column) for row in rows]
    axes.plot(hits, [v for v, _, _ in values], line, label=label, markersize=4, linewidth=1.3, **style)
    axes.fill_between(hits, [low for _, low, _ in values], [high for _, _, high in values], color=style["color"], alpha=0.15)


def caption(comparison):
    context = comparison.context
    repetitions = sorted({row["repetitions"] for row in comparison.rows if "skipped" not in row})
    count = f"{repetitions[0]}" if len(repetitions) == 1 else f"{repetitions[0]} to {repetitions[-1]}"
    return (
        f"medians of {count} interleaved runs, bands: smallest to largest; {context['threads']} threads, seed {context['seed']}, "
        f"{context['settings']}\n{context['machine']}, {context['compiler']}, Embree {context['libraries']['embree']}, "
        f"FLANN {context['libraries']['flann']}, commit {context['commit']}"
    )


def chart(comparison, name, title, unit, draw):
    """One panel per scene, same axes; `draw(axes, scene)` fills a panel."""
    scenes = comparison.scenes
    figure, panels = plt.subplots(1, len(scenes), figsize=(1.2 + 3.4 * len(scenes), 4.6), sharey=True, squeeze=False)
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
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", bbox_to_anchor=(0.5, 0.06), ncol=min(len(labels), 2 * len(scenes)), fontsize=7)
    figure.tight_layout(rect=(0, 0.16, 1, 1))
    folder = comparison.folder / "charts"
    folder.mkdir(exist_ok=True)
    figure.savefig(folder / f"{name}.png", dpi=130)
    plt.close(figure)


def draw_methods(comparison, column):
    def draw(axes, scene):
        for method, style in STYLE.items():
            if rows := comparison.series(scene, method):
                draw_line(axes, rows, column, style, method)

    return draw


def draw_gather(comparison):
    def draw(axes, scene):
        for method, style in STYLE.items():
            if rows := comparison.series(scene, method):
                draw_line(axes, rows, "gather_us_per_query", style, f"{method}, image order")
                draw_line(axes, rows, "gather_us_per_query_shuffled", style, f"{method}, shuffled", "--")

    return draw


def draw_bytes(comparison):
    def draw(axes, scene):
        for method, style in STYLE.items():
            if rows := comparison.series(scene, method):
                draw_line(axes, rows, "bytes", style, method)
        if rows := comparison.series(scene, LIGHT_MAP):
            draw_line(axes, rows, "insert_bytes", STYLE[LIGHT_MAP], f"{LIGHT_MAP}, while tracing", "--")

    return draw


def draw_time_to_map(comparison):
    def draw(axes, scene):
        for method, style in STYLE.items():
            if rows := comparison.series(scene, method):
                axes.plot([r["hits"] for r in rows], [map_seconds(r) for r in rows], label=method, markersize=4, **style)
        if rows := comparison.series(scene, LIGHT_MAP) or comparison.series(scene, PHOTON_MAP):
            axes.plot([r["hits"] for r in rows], [r["trace_seconds"] for r in rows], ":", color="#555555", label="trace alone")

    return draw


def main():
    comparison = Comparison(sys.argv[1])
    chart(comparison, "insert", "Inserting a hit into the store", "ns per hit and thread", draw_methods(comparison, "insert_ns_per_hit"))
    chart(comparison, "gather", "Irradiance at a visible point, one thread", "µs per query", draw_gather(comparison))
    chart(comparison, "bytes", "Memory of the map with its index", "bytes", draw_bytes(comparison))
    chart(comparison, "time-to-map", "From nothing to a map that answers", "s: empty store, trace, insert, build", draw_time_to_map(comparison))


if __name__ == "__main__":
    main()
