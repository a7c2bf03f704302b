"""Who reaches an error first, of curves that are known exactly."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.study.findings import findings_of
from report.study.first import first_rows
from study_laws import SHLM, exact_curve


def curves_of(light_floor=0.0):
    """The light map's squared error is 1000 / hits, at 1 us a hit and 2 MiB; the photon map's four times that, at 2 us and 64 bytes a hit."""
    curves = (
        exact_curve(SHLM, lambda h: 1e3 / h + light_floor, lambda h: 1e-6 * h, lambda h: 2 * 2**20),
        exact_curve("photonmap/compact/r0.01/disc", lambda h: 4e3 / h, lambda h: 2e-6 * h, lambda h: 64 * h),
    )
    return {curve.method.name: curve for curve in curves}


def rows(curves):
    return first_rows({"room": curves}, {"room": findings_of(curves)})


class FirstToReach(unittest.TestCase):
    def test_time_bytes_and_ratio(self):
        ten, five, two, one = rows(curves_of())  # 1 % wants 1e7 hits of the light map, which it has, and 4e7 of the photon map
        self.assertEqual(ten[:2], ["room", "10 %"])
        self.assertEqual(ten[2], "100\u00a0ms, 2\u00a0MiB (shlm/L2/radiance/surface4)")
        self.assertEqual(ten[3], "800\u00a0ms, 24.4\u00a0MiB (photonmap/r0.01/disc)")
        self.assertEqual(ten[4], "8 x, 12 x")
        self.assertEqual([two[1], two[4]], ["2 %", "8 x, 310 x"])
        self.assertEqual([one[1], one[4]], ["1 %", "-"])

    def test_who_does_not_reach_it_is_named_with_what_it_has(self):
        (ten, five, *_) = rows(curves_of(light_floor=0.01))
        self.assertEqual(ten[2], "nobody; nearest 10\u00a0%: 10\u00a0s, 2\u00a0MiB (shlm/L2/radiance/surface4)")
        self.assertEqual(ten[4], "-")
        self.assertNotIn("nobody", five[3])

    def test_a_study_of_light_maps_alone(self):
        light = {SHLM: curves_of()[SHLM]}
        self.assertEqual([row[3:] for row in rows(light)][0], ["-", "-"])


if __name__ == "__main__":
    unittest.main()
