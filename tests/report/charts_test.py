"""The charts of a comparison, on tables made up for the purpose: charts_test.py"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.compare import charts
import matplotlib.pyplot as plt

from report.compare.comparison import Comparison
from known_methods import facts_of

LIGHT_MAP, FLANN, GRID = "shlm/L2/radiance/surface4", "photonmap/flann/k50/disc", "photonmap/grid/r0.003/disc"
CONTEXT = {"threads": 2, "seed": 1, "settings": "s", "machine": "m", "compiler": "c", "libraries": {"embree": "3", "flann": "1"}, "commit": "x"}
NAMES = {"insert", "gather", "bytes", "memory-wall", "time-to-map"}
WALL = 20e9
COLUMNS = ("trace_seconds", "making_room_seconds", "trace_and_insert_seconds", "build_seconds", "ratio_to_null_sink", "gather_us_per_query",
           "gather_us_per_query_shuffled", "insert_bytes")


def row(method, hits, peak, scene="room"):
    made = {"scene": scene, **facts_of(method), "hits_asked": hits, "hits": hits, "repetitions": 3, "bytes": peak / 2, "peak_growth_bytes": peak,
            "max_memory_bytes": WALL}
    return made | dict.fromkeys(COLUMNS, 1.0)


def skipped(method, hits, scene="room"):
    return {"scene": scene, **facts_of(method), "hits_asked": hits, "skipped": "needs 80 GiB", "needed_bytes": 86 * hits, "max_memory_bytes": WALL}


class Charts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(plt.close, "all")

    def comparison(self, rows):
        (Path(self.folder.name) / "compare.json").write_text(json.dumps({"context": CONTEXT, "rows": rows}), encoding="utf-8")
        return Comparison(self.folder.name)

    def wall_axes(self, rows):
        figure, axes = plt.subplots()
        charts.draw_memory_wall(self.comparison(rows))(axes, "room")
        return axes

    def test_all_are_drawn_whatever_was_measured(self):
        some = [row(LIGHT_MAP, 1000, 1e8), row(FLANN, 1000, 1e6)]
        for rows in (some, some[:1], some[1:], [skipped(GRID, 1000)], some + [row(GRID, 1000, 1e6, "hall"), skipped(LIGHT_MAP, 1000, "hall")]):
            self.comparison(rows)
            charts.main([self.folder.name])
            drawn = {file.stem for file in (Path(self.folder.name) / "charts").iterdir()}
            self.assertEqual(drawn, NAMES)

    def test_insertion_is_the_paired_difference_of_walls(self):
        made = row(LIGHT_MAP, 1000, 1e8) | {"threads": 2, "trace_seconds": 1e-5, "ratio_to_null_sink": 1.5, "ratio_to_null_sink_range": [1.4, 1.6], "insert_ns_per_hit": 3}
        figure, axes = plt.subplots()
        charts.draw_methods(self.comparison([made]), charts.INSERT_NS)(axes, "room")
        self.assertAlmostEqual(axes.get_lines()[0].get_ydata()[0], 10)

    def test_the_wall_and_what_lies_beyond(self):
        rows = [row(FLANN, 10**6, 80e6), row(FLANN, 10**8, 8e9), skipped(FLANN, 10**9), row(LIGHT_MAP, 10**9, 120e6)]
        axes = self.wall_axes(rows)
        lines = {(line.get_linestyle(), line.get_marker()): line for line in axes.get_lines()}
        measured = lines["-", "o"]
        self.assertEqual(list(measured.get_xdata()), [10**6, 10**8])
        beyond = lines["--", "None"]
        self.assertEqual(beyond.get_xdata()[0], 10**8)
        self.assertAlmostEqual(beyond.get_xdata()[-1] / 1e9, 1)
        self.assertAlmostEqual(beyond.get_ydata()[-1] / 80e9, 1, places=6)
        crossing = lines["None", "x"]
        self.assertAlmostEqual(crossing.get_xdata()[0] / 250e6, 1, places=6)
        self.assertEqual(crossing.get_ydata()[0], WALL)
        self.assertIn(WALL, [line.get_ydata()[0] for line in axes.get_lines() if line.get_label() == "--max-memory"])
        texts = {text.get_text() for text in axes.texts}
        self.assertLessEqual({"\u2248 74.5\u00a0GiB", "114\u00a0MiB", "the wall: 18.6\u00a0GiB"}, texts)  # extrapolated, measured, the wall

    def test_labels_do_not_cover_each_other(self):
        axes = self.wall_axes([row(f"photonmap/{engine}/k50/disc", 10**8, 8e9) for engine in ("flann", "nanoflann", "compact")])
        places = sorted(text.get_position()[1] for text in axes.texts if text.get_text().startswith("\u2248"))
        self.assertEqual(len(places), 3)
        for low, high in zip(places, places[1:]):
            self.assertGreater(high / low, 1.5)

    def test_one_photon_map_stands_for_its_engine(self):
        rows = [row(m, 1000, 1e6) for m in ("photonmap/flann/r0.01/disc", FLANN, "photonmap/flann/k200/disc", GRID, "photonmap/grid/r0.1/disc", LIGHT_MAP)]
        self.assertEqual(list(charts.styles(self.comparison(rows))), [FLANN, GRID, LIGHT_MAP])


if __name__ == "__main__":
    unittest.main()
