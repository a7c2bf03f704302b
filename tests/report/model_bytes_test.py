"""model_bytes.py's reckoning: which maps are the smallest for an error, and what lies between two of them."""

import math
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from known_methods import facts_of
from report.fit.model_bytes import ADAPTIVE, PHOTON_MAP, bytes_for, front, kind_of, rows_of
from report.study.methods import method_of


def method_named(name):
    return method_of(facts_of(name))


class Kinds(unittest.TestCase):
    def test_rows_say_what_a_method_is(self):
        self.assertEqual(kind_of(method_named("shlm/a2.5/normalised/bilinear")), ADAPTIVE)
        self.assertEqual(kind_of(method_named("shlm/AD/radiance/bilinear/t64/half")), "AD")
        self.assertEqual(kind_of(method_named("shlm/L0/normalised/own")), "L0")
        self.assertEqual(kind_of(method_named("photonmap/compact/k50/disc")), PHOTON_MAP)


class Front(unittest.TestCase):
    def test_keeps_what_nobody_smaller_beats(self):
        points = [(400, 5.0), (100, 20.0), (200, 30.0), (300, 10.0), (500, 7.0)]
        self.assertEqual(front(points), [(100, 20.0), (300, 10.0), (400, 5.0)])

    def test_between_neighbours_it_is_straight_in_log_log(self):
        kept = [(100, 20.0), (400, 5.0)]
        self.assertAlmostEqual(bytes_for(kept, 10.0), 200)
        self.assertAlmostEqual(bytes_for(kept, 5.0), 400)
        self.assertEqual(bytes_for(kept, 25.0), 100)
        self.assertTrue(math.isnan(bytes_for(kept, 4.9)))


class Table(unittest.TestCase):
    def test_has_the_adaptive_front_beside_the_uniform_one(self):
        found = {
            "shlm/a5/normalised/bilinear/face/t16384": (3072, 10.0),
            "shlm/a5/normalised/bilinear/uv": (4096, 10.0),
            "shlm/L0/normalised/bilinear/half": (5120, 10.0),
            "photonmap/compact/k50/disc": (1024 * 1024, 20.0),
        }
        found = {method_named(name): point for name, point in found.items()}
        self.assertEqual(rows_of("box", 10_000_000, found), [("box", "1e+07", "a5/face/t16384", "10.00", "3", "5", "1.7", "-")])


if __name__ == "__main__":
    unittest.main()
