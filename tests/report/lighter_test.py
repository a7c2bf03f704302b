"""lighter.py's reckoning: the best of each family, slopes, what it takes to an error, and ratios of variance."""

import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report import lighter

SIZES = (1e5, 1e6, 1e7)


def point(hits, error, variance=1e-4):
    """`error` relative, not squared."""
    return {"hits_asked": hits, "hits": hits, "error": error**2, "variance": variance, "total_seconds": hits / 1e7, "bytes": 1000.0}


def summary(light_map, photon_map, variance=1e-4):
    """A study of one scene, whose light maps of two sizes have these errors at 1e5 hits. Squared errors fall as hits^-1/2."""
    falling = lambda first: [point(hits, first * (hits / 1e5) ** -0.25, variance) for hits in SIZES]
    methods = {
        "shlm/F2/radiance/bilinear/t64": falling(2 * light_map),
        "shlm/F2/radiance/bilinear/t128": falling(light_map),
        "photonmap/compact/k50/cone": falling(photon_map),
    }
    return {"context": {"machine": "any", "commit": "abc"}, "scenes": {"box": {"methods": methods}}}


class Figures(unittest.TestCase):
    def setUp(self):
        found = lighter.family_rows(summary(0.2, 0.4)["scenes"]["box"], "box")
        self.light_map, self.photon_map = found

    def test_the_best_method_of_each_size_counts(self):
        self.assertEqual([best["method"] for best in self.light_map["best"]], ["shlm/F2/radiance/bilinear/t128"] * 3)
        self.assertEqual(self.photon_map["family"], "photonmap")

    def test_the_slope_is_that_of_the_squared_error(self):
        self.assertAlmostEqual(self.light_map["slope"], -0.5)

    def test_hits_are_reckoned_between_sizes(self):
        best = lighter.best_at_each_size(summary(0.2, 0.4)["scenes"]["box"]["methods"])
        self.assertAlmostEqual(lighter.hits_to(best, 0.1), 1.6e6, delta=1)  # (0.2 / 0.1)^4 times as many
        self.assertEqual(lighter.hits_to(best, 0.5), 1e5)
        self.assertIsNone(lighter.hits_to(best, 0.01))

    def test_seconds_are_those_of_a_whole_run(self):
        methods = summary(0.2, 0.4)["scenes"]["box"]["methods"]
        self.assertEqual(lighter.seconds_to(methods, 0.1), 1.0)
        self.assertIsNone(lighter.seconds_to(methods, 0.01))

    def test_bases_have_their_best_number_of_texels(self):
        rows = lighter.basis_rows(summary(0.2, 0.4)["scenes"]["box"], "box")
        self.assertEqual([(row["basis"], row["hits_asked"]) for row in rows], [("F2/radiance", hits) for hits in SIZES])
        self.assertTrue(all(row["method"].endswith("t128") for row in rows))


class Report(unittest.TestCase):
    def test_sets_both_kinds_of_direct_light_beside_each_other(self):
        with tempfile.TemporaryDirectory() as name:
            out = Path(name)
            self.assertEqual(lighter.main([name]), 2)
            found = {"photons": summary(0.2, 0.4), "traced": summary(0.1, 0.3), "random-photons": summary(0.2, 0.4, 3e-4), "sobol-photons": summary(0.2, 0.4, 1e-4)}
            for folder, content in found.items():
                (out / folder).mkdir()
                (out / folder / "summary.json").write_text(json.dumps(content), encoding="utf-8")
            self.assertEqual(lighter.main([name]), 0)
            document = json.loads((out / "lighter.json").read_text(encoding="utf-8"))
            errors = [row["best"][0]["error"] for direct in ("photons", "traced") for row in document["families"][direct]]
            for error, expected in zip(errors, (0.2, 0.4, 0.1, 0.3)):
                self.assertTrue(math.isclose(error, expected))
            self.assertTrue(all(math.isclose(row["variance_ratio"], 3) for row in document["emission"]))
            text = (out / "lighter.md").read_text(encoding="utf-8")
            self.assertIn("| box | light map | 20 / 10 | 11.2 / 5.62 | 6.32 / 3.16 |", text)
            self.assertIn("| box | light map | photons | 3.00 | 3.00 | 3.00 |", text)


if __name__ == "__main__":
    unittest.main()
