"""The verdict on fits beside a search whose best is known."""

import contextlib
import io
import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.fit import search as fit_search
from report.fit import verdict as fit_verdict
from report.study.data import Study, StudyError
from synthetic_study import Law, Plan, write_study

TARGET = 0.1
# variance 100 / N is the target's square at N = 1e4 / (1 - bias^2 / 0.01)
FAST = Law(variance=lambda n: 400 / n, bias_sq=lambda n: 0.0, seconds=lambda n: 1e-5 * n, bytes=lambda n: 8e6)
SMALL = Law(variance=lambda n: 4000 / n, bias_sq=lambda n: 0.0, seconds=lambda n: 1e-5 * n, bytes=lambda n: 1e6)
PHOTONS = Law(variance=lambda n: 400 / n, bias_sq=lambda n: 0.04, bytes=lambda n: 23 * n)
METHODS = {"shlm/L2/radiance/own/t4096/h0": FAST, "shlm/L0/normalised/own/t1024/h0": SMALL,
           "photonmap/compact/r0.1/disc": PHOTONS}


def fit_of(**light_map):
    choice = {"method": "shlm/L2/radiance/own/t4096/h0", "hits": 60000, "error": 0.09, "seconds": 0.8, "bytes": 4e6}
    return {
        "scene": "cornell",
        "target": TARGET,
        "light_map": {"reached": True, "choice": choice, **light_map},
        "photon_map": {"reached": False, "reason": "its blur is 20 %"},
    }


class FitSearch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        write_study(cls.folder, Plan(METHODS))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def verdicts(self, *fits):
        return fit_search.verdicts(Study(self.folder), fits)

    def test_costs_are_relative_to_the_best_of_the_search(self):
        light_map, photon_map = self.verdicts(fit_of())
        self.assertEqual(light_map.fastest, "shlm/L2/radiance/own/t4096/h0")
        self.assertEqual(light_map.smallest, "shlm/L0/normalised/own/t1024/h0")
        # 0.6 and 0.4 s, each with the gathers' 0.01 s, whatever fit says; jittered by 3 % at most, and a line between sizes a factor of 10 apart
        self.assertAlmostEqual(light_map.time_ratio, 0.61 / 0.41, delta=0.15)
        self.assertAlmostEqual(light_map.bytes_ratio, 8.0, delta=0.01)
        self.assertEqual((photon_map.method, photon_map.fastest), ("", ""))
        self.assertEqual(photon_map.reason, "its blur is 20 %")

    def test_verified_runs_replace_predictions(self):
        runs = [{"error": e, "seconds": s, "bytes": 2e6} for e, s in ((0.09, 0.4), (0.11, 0.41), (0.095, 9.0))]
        light_map = self.verdicts(fit_of(verified=runs))[0]
        self.assertEqual(light_map.meeting, 2)
        self.assertAlmostEqual(light_map.measured_rms, math.sqrt((0.09**2 + 0.11**2 + 0.095**2) / 3))
        self.assertIn("2 of 3", fit_search.cells(light_map))

    def test_what_was_not_searched_has_no_ratio(self):
        for change in ({"hits": 1e9}, {"method": "shlm/L4/radiance/own/t4096/h0"}):
            fit = fit_of()
            fit["light_map"]["choice"] |= change
            light_map = self.verdicts(fit)[0]
            self.assertTrue(math.isnan(light_map.time_ratio) and math.isnan(light_map.bytes_ratio), change)

    def test_says_what_was_out_of_reach(self):
        photon_map = fit_search.cells(self.verdicts(fit_of())[1])
        self.assertEqual(len(photon_map), len(fit_search.HEADS))
        self.assertIn("out of reach: its blur is 20 %", photon_map)
        self.assertIn("never", photon_map)

    def test_refuses_scenes_that_were_not_searched(self):
        with self.assertRaises(StudyError):
            self.verdicts({**fit_of(), "scene": "atrium"})

    def run_main(self, *words):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            return fit_search.main([*map(str, words)]), out.getvalue(), err.getvalue()

    def test_prints_a_table_or_one_line(self):
        file = self.folder / "fit.json"
        file.write_text(json.dumps(fit_of()), encoding="utf-8")
        code, out, err = self.run_main(self.folder, file)
        self.assertEqual((code, err), (0, ""))
        self.assertIn("| cornell | 10 |", out)
        for broken in ("", "{}", "[]"):
            file.write_text(broken, encoding="utf-8")
            code, out, err = self.run_main(self.folder, file)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1))


class FitVerdict(unittest.TestCase):
    def test_says_what_runs_measure_with_and_without_their_worst_points(self):
        runs = [{"error": 0.1, "worst_share": 0.5, "seconds": 2, "bytes": 3e6},
                {"error": 0.12, "worst_share": 0.75, "seconds": 4, "bytes": 3e6}]
        cells = fit_verdict.cells({**fit_of(verified=runs), "least": "time"}, "light_map")
        estimated, measured, without_worst = (float(cell.removesuffix("\u00a0%")) for cell in cells[8:11])
        self.assertEqual(estimated, 9.0)
        self.assertAlmostEqual(measured, 100 * math.sqrt((0.1**2 + 0.12**2) / 2), delta=0.1)
        self.assertAlmostEqual(without_worst, 100 * math.sqrt((0.1**2 * 0.5 + 0.12**2 * 0.25) / 2), delta=0.01)
        self.assertEqual(cells[11], "1 of 2")

    def test_rows_have_as_many_cells_as_the_head(self):
        for kind in ("light_map", "photon_map"):
            self.assertEqual(len(fit_verdict.cells({**fit_of(), "least": "time"}, kind)), len(fit_verdict.HEADS), kind)


if __name__ == "__main__":
    unittest.main()
