"""The atrium at a billion hits beside the photon map at the end of its memory: bench/report billion-figure FOLDER

FOLDER has light-map.png and photon-map.png, pictures of one size, and study/summary.json, which has both methods' rows.
Writes FOLDER/atrium-billion.jpg.
"""

import json
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot as plt

from report.study.text import METRIC
from report.text import bytes_text, hits_text, machine_text, percent_text, seconds_text

SCENE = "atrium"
DPI = 100
MARGIN, TITLE, FOOT = 0.1, 0.3, 0.5  # inches


def largest(methods, beginning):
    """(name, row) of the most hits among the methods whose names begin so; the least error where they are equal."""
    rows = [(name, points[-1]) for name, points in methods.items() if name.startswith(beginning) and points]
    return max(rows, key=lambda one: (one[1]["hits_asked"], -one[1]["error"]))


def words(name, row):
    return (
        f"{name}: {hits_text(row['hits'])} hits, {seconds_text(row['trace_seconds'] + row['insert_seconds'])} traced and inserted, "
        f"{seconds_text(row['build_seconds'])} built, {bytes_text(row['bytes'])}, relative RMS error {percent_text(row['error'])}"
    )


def main(arguments):
    folder = Path(arguments[0])
    summary = json.loads((folder / "study" / "summary.json").read_text())
    methods = summary["scenes"][SCENE]["methods"]
    panels = [("light-map.png", *largest(methods, "shlm")), ("photon-map.png", *largest(methods, "photonmap"))]
    pictures = [matplotlib.image.imread(folder / file) for file, _, _ in panels]
    height, width = pictures[0].shape[:2]
    across = width / DPI + 2 * MARGIN
    down = len(panels) * (height / DPI + TITLE) + FOOT
    figure = plt.figure(figsize=(across, down), dpi=DPI)
    for number, ((_, name, row), picture) in enumerate(zip(panels, pictures)):
        top = down - number * (height / DPI + TITLE)
        figure.text(MARGIN / across, (top - 0.22) / down, words(name, row), fontsize=10.5)
        place = (MARGIN / across, (top - TITLE - height / DPI) / down, width / DPI / across, height / DPI / down)
        axes = figure.add_axes(place)
        axes.imshow(picture, interpolation="nearest")
        axes.set_axis_off()
    context = summary["context"]
    caption = f"{METRIC}; at 96 x 54 points, seed 1. {context['threads']} threads; {machine_text(context)}"
    figure.text(MARGIN / across, 0.08 / down, caption, fontsize=6.5, color="#444444", wrap=True)
    figure.savefig(folder / f"{SCENE}-billion.jpg", dpi=DPI, pil_kwargs={"quality": 90})
