"""What fragment programs are said to cost and to answer, on made-up measurements with known answers."""

import copy
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report import realtime
from report.claims import realtime_claims as claims
from synthetic_realtime import document

class Claims(unittest.TestCase):
    def test_both_hold(self):
        normals, fragments = claims.measured_by_fragments(document())
        self.assertEqual((normals.verdict, fragments.verdict), ("confirmed", "confirmed"))
        self.assertEqual(normals.scenes, ("bumpy",))  # cornell has no normal maps
        self.assertEqual(normals.runs, (3, 3))
        self.assertIn("10", normals.figure)
        self.assertIn("7 fetches", fragments.figure)

    def test_one_run_decides_nothing(self):
        self.assertEqual({found.verdict for found in claims.measured_by_fragments(document(seeds=1))}, {"not decided"})

    def test_a_cost_that_grows_refutes(self):
        grown = document()
        grown["rows"][-1]["fetches"] += 1
        self.assertEqual(claims.realtime(grown).verdict, "refuted")
        self.assertIn("DEPENDS", realtime.markdown(grown))

    def test_pixels_that_differ_refute(self):
        off = document()
        next(r for r in off["rows"] if r["filter"] == "exact")["rms"] = 2e-4
        self.assertEqual(claims.realtime(off).verdict, "refuted")

    def test_what_is_hardly_better_is_a_condition(self):
        hardly = document()
        other = [copy.deepcopy(r) | {"scene": "atrium"} for r in hardly["rows"] if r["scene"] == "bumpy"]
        for r in other:
            r["error"] = 0.3 if r["basis"] == "L2" else 0.35
        hardly["rows"] += other
        hardly["scenes"].append({**hardly["scenes"][0], "scene": "atrium"})
        found = claims.normal_maps(hardly)
        self.assertEqual(found.verdict, "conditional")
        self.assertIn("bumpy, not in atrium", found.plain)

    def test_one_number_of_hits_says_nothing_of_others(self):
        few = document()
        few["rows"] = [r for r in few["rows"] if r["hits_asked"] == 1e7]
        self.assertEqual(claims.realtime(few).verdict, "not measured yet")


class Report(unittest.TestCase):
    def test_has_errors_costs_and_sizes(self):
        text = realtime.markdown(document())
        self.assertIn("| bumpy | L2 | 1e-6 | 0.01 | 10.2\u00a0% | 10.2\u00a0% | 0.29 |", text)
        self.assertIn("| L2 | 54 | 9 | 7 | 224 |", text)
        self.assertIn("the same at both numbers of hits", text)
        self.assertIn("| bumpy | 100 x 90 |", text)


if __name__ == "__main__":
    unittest.main()
