"""What is read off curves of error: slopes, targets, crossings, fronts. Bounds on random quantities come from SIGNIFICANCE."""

import math
import sys
import types
import unittest
from dataclasses import replace
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

import numpy as np
from report.study.bootstrap import CONFIDENCE
from report.study.crossings import (
    NOT_COMPARABLE,
    intervals_below_zero,
    more_accurate_at_equal,
    more_accurate_at_equal_bytes,
    single_crossings,
    smaller_at_equal_hits,
)
from report.study.curves import Curve, curves_of
from report.study.data import Study
from report.study.front import pareto_front
from report.study.groups import groups
from study_laws import (
    FOUR_METHODS,
    PHOTONS,
    SHLM,
    SIGNIFICANCE,
    Folder,
    exact_curve,
    exact_point,
    fixed_k_law,
    growing_k_law,
    least_successes,
    light_map_law,
    radius_law,
    z_for,
)
from report.study.methods import FIXED_K, FIXED_RADIUS, GROWING_K, LIGHT_MAP, OTHER, method_of
from report.study.slopes import slope_finding
from report.study.targets import AT_FIRST, BEYOND, NEVER, REACHED, bytes_to_reach, time_to_reach, winners
from synthetic_study import Law, Plan, write_study
from known_methods import facts_of


def method_named(name):
    return method_of(facts_of(name))


class Methods(unittest.TestCase):
    def test_rows_say_family_and_settings(self):
        found = method_named("shlm/L4/normalised/bilinear/t65536")
        self.assertEqual(
            (found.family, found.order, found.weight, found.gather, found.texels),
            (LIGHT_MAP, 4, "normalised", "bilinear", 65536),
        )
        self.assertEqual(found.least_hits, 100)
        self.assertEqual(method_named("shlm/L2/radiance/own/t64/h0").least_hits, 0)
        for name, family, number, kernel in (
            ("photonmap/compact/k50/disc", FIXED_K, 50, "disc"),
            ("photonmap/compact/k0.05n23/cone", GROWING_K, 0.05, "cone"),
            ("photonmap/compact/r0.01/epanechnikov", FIXED_RADIUS, 0.01, "epanechnikov"),
        ):
            found = method_named(name)
            self.assertEqual((found.family, found.number, found.kernel), (family, number, kernel))
        self.assertEqual(method_named("path tracing").family, OTHER)


class SettledPoints(unittest.TestCase):
    def test_are_those_whose_texels_show_their_own_hits(self):
        def point(hits):
            run = types.SimpleNamespace(rows=[{"texels": 1000}])
            return types.SimpleNamespace(hits=hits, run=run)

        points = tuple(point(hits) for hits in (1e4, 1e5, 1e6))
        for name, settled in (("shlm/L2/radiance/surface4", 2), ("shlm/L2/radiance/surface4/h10", 3), (PHOTONS, 3)):
            self.assertEqual(len(Curve(method_named(name), points).settled_points), settled)


class Slopes(Folder):
    def findings(self, methods, seeds=8, scenes=("cornell",)):
        write_study(
            self.folder,
            Plan(methods, scenes=scenes, sizes=(10_000, 100_000, 1_000_000, 10_000_000), seeds=seeds),
        )
        return {
            s: {n: slope_finding(c) for n, c in curves.items()}
            for s, curves in curves_of(Study(self.folder)).items()
        }

    def test_variance_has_the_slope_of_theory(self):
        found = self.findings(FOUR_METHODS)["cornell"]
        for name, theory in (
            (SHLM, -1),
            (PHOTONS, 0),
            ("photonmap/compact/k0.05n23/cone", -2 / 3),
            ("photonmap/compact/r0.01/disc", -1),
        ):
            slope = found[name].variance
            # log variance at a size has the deviation sqrt(2 / (seeds - 1) / values); the sizes are independent here.
            steps = np.log(10) * (np.arange(slope.sizes) - (slope.sizes - 1) / 2)
            deviation = math.sqrt(2 / 7 / 1800) / math.sqrt(np.sum(steps**2))
            self.assertAlmostEqual(slope.value, theory, delta=z_for(SIGNIFICANCE) * deviation, msg=name)

    def test_slopes_over_time_and_bytes(self):
        # Time grows as the hits, the photon map's bytes as their square root, the light map's not at all.
        light = replace(light_map_law(floor=1e-9), gather_seconds=lambda hits: 0.0)
        photons = replace(radius_law(), gather_seconds=lambda hits: 0.0, bytes=lambda hits: 1e3 * hits**0.5)
        found = self.findings({SHLM: light, "photonmap/compact/r0.01/disc": photons})["cornell"]
        for finding in found.values():
            # The clock's jitter of 3 %, over three decades.
            self.assertAlmostEqual(finding.over_seconds.value, finding.error.value, delta=0.01)
        self.assertIsNone(found[SHLM].over_bytes)
        radius = found["photonmap/compact/r0.01/disc"]
        self.assertAlmostEqual(radius.over_bytes.value, 2 * radius.error.value, places=9)

    def test_sizes_where_the_bias_shows_are_not_fitted(self):
        found = self.findings({SHLM: light_map_law(floor=1e-3, noise=1e3)})["cornell"][SHLM]
        self.assertEqual(found.error.sizes, 2)  # variance / bias^2: 100, 10, 1, 0.1
        self.assertEqual(found.variance.sizes, 4)
        exact = math.log10((1e-2 + 1e-3) / (1e-1 + 1e-3))
        deviation = (
            math.sqrt(2) * math.sqrt(2 / (8 * 1800)) / math.log(10)
        )  # of means of squares at two sizes
        self.assertAlmostEqual(found.error.value, exact, delta=z_for(SIGNIFICANCE) * deviation)

    def test_neighbour_counts_are_fitted_from_the_first_hits_on(self):
        name = "photonmap/compact/k0.05n23/disc"
        found = self.findings({PHOTONS: fixed_k_law(), name: growing_k_law()})["cornell"]
        for finding in found.values():
            self.assertEqual((finding.error.sizes, finding.variance.sizes), (3, 3))  # of four, without 1e4

    def test_nothing_is_fitted_where_the_floor_is_everywhere(self):
        found = self.findings({SHLM: light_map_law(floor=1.0, noise=1.0)})["cornell"][SHLM]
        self.assertIsNone(found.error)
        self.assertEqual(found.verdict, "-")

    def test_intervals_agree_with_theory(self):
        scenes = tuple(f"scene{i}" for i in range(20))
        methods = {
            name: Law(lambda h: 1e3 / h, lambda h: 0.0) for name in (SHLM, "photonmap/compact/r0.01/disc")
        }
        write_study(self.folder, Plan(methods, scenes=scenes, sizes=(10_000, 100_000), points=100))
        found = [
            slope_finding(c) for curves in curves_of(Study(self.folder)).values() for c in curves.values()
        ]
        agree = sum(f.verdict == "agrees within its interval" for f in found)
        self.assertGreaterEqual(agree, least_successes(len(found), CONFIDENCE))

    def test_another_slope_is_refused(self):
        found = self.findings({SHLM: Law(lambda h: 10 * h**-0.5, lambda h: 0.0)})["cornell"][SHLM]
        self.assertTrue(found.verdict.startswith("no, by +"), found.verdict)
        self.assertTrue(found.error.agrees_with(-0.5))


class Targets(unittest.TestCase):
    def test_interpolates_power_laws_exactly(self):
        curve = exact_curve(PHOTONS, lambda h: 1e3 / h, lambda h: 1e-6 * h, lambda h: 73 * h)
        found = time_to_reach(curve, 0.05)  # 1e3 / h = 0.0025
        self.assertEqual(found.kind, REACHED)
        self.assertAlmostEqual(found.cost, 0.4, places=9)
        self.assertAlmostEqual(bytes_to_reach(curve, 0.05).cost, 73 * 4e5, delta=1)

    def test_reached_at_the_first_size(self):
        curve = exact_curve(PHOTONS, lambda h: 10 / h, lambda h: 1e-6 * h, lambda h: 73 * h)
        found = time_to_reach(curve, 0.05)
        self.assertEqual(found.kind, AT_FIRST)
        self.assertAlmostEqual(found.cost, 0.01, places=12)

    def test_bytes_that_stay_are_no_bound(self):
        curve = exact_curve(SHLM, lambda h: 10 / h, lambda h: 1e-6 * h, lambda h: 32e6)
        found = bytes_to_reach(curve, 0.05)
        self.assertEqual(found.kind, REACHED)
        self.assertAlmostEqual(found.cost, 32e6, delta=1)

    def test_never_below_what_hits_do_not_lower(self):
        bias = exact_curve(SHLM, lambda h: 1e-3 + 1e2 / h, lambda h: 1e-6 * h, lambda h: 1e6, bias_sq=1e-3)
        self.assertEqual(time_to_reach(bias, 0.02).kind, NEVER)
        self.assertEqual(time_to_reach(bias, 0.05).kind, REACHED)
        noise = exact_curve(PHOTONS, lambda h: 0.02, lambda h: 1e-6 * h, lambda h: 73 * h)
        self.assertEqual(time_to_reach(noise, 0.05).kind, NEVER)

    def test_beyond_where_both_parts_fall(self):
        curve = exact_curve(
            "photonmap/compact/k0.05n23/disc",
            lambda h: 100 * h ** (-2 / 3),
            lambda h: h,
            lambda h: h,
            bias_sq=1e-3,
        )
        found = time_to_reach(curve, 0.01)
        self.assertEqual((found.kind, found.largest_hits), (BEYOND, 1e7))

    def test_winners(self):
        curves = {
            SHLM: exact_curve(SHLM, lambda h: 1e3 / h, lambda h: 1e-6 * h, lambda h: 32e6),
            PHOTONS: exact_curve(PHOTONS, lambda h: 2e3 / h, lambda h: 1e-6 * h, lambda h: 73 * h),
        }
        self.assertEqual(winners({n: time_to_reach(c, 0.05) for n, c in curves.items()}), [SHLM])
        self.assertEqual(winners({n: time_to_reach(c, 1e-4) for n, c in curves.items()}), [])
        self.assertEqual(winners({n: bytes_to_reach(curves[SHLM], 0.05) for n in curves}), list(curves))


class Crossings(unittest.TestCase):
    def setUp(self):
        self.light = exact_curve(SHLM, lambda h: 1e4 / h, lambda h: 2e-6 * h, lambda h: 7.3e6)
        self.photons = exact_curve(PHOTONS, lambda h: 0.02, lambda h: 1e-6 * h, lambda h: 73 * h)

    def test_one_crossing(self):
        found = more_accurate_at_equal("hits", self.light, self.photons)
        self.assertAlmostEqual(found.crossing, 5e5, delta=1)
        self.assertIsNone(found.intervals[0][1])
        self.assertAlmostEqual(found.band[0], found.crossing, delta=1)

    def test_equal_time(self):
        self.assertAlmostEqual(
            more_accurate_at_equal("seconds", self.light, self.photons).crossing, 1.0, places=9
        )

    def test_equal_bytes(self):
        falling = exact_curve(PHOTONS, lambda h: 2e3 / h, lambda h: 1e-6 * h, lambda h: 73 * h)
        found = more_accurate_at_equal_bytes(self.light, falling)  # 7.3e6 bytes: 1e5 photons, error 0.02
        self.assertAlmostEqual(found.crossing, 5e5, delta=1)
        self.assertAlmostEqual(smaller_at_equal_hits(self.light, falling).crossing, 1e5, delta=1)

    def test_always_and_never(self):
        worse = exact_curve(PHOTONS, lambda h: 1e9 / h, lambda h: 1e-6 * h, lambda h: 73 * h)
        self.assertTrue(more_accurate_at_equal("hits", self.light, worse).always)
        self.assertTrue(more_accurate_at_equal("hits", worse, self.light).never)

    def test_no_common_range(self):
        later = exact_curve(PHOTONS, lambda h: 0.02, lambda h: 1e-6 * h, lambda h: 73 * h, sizes=(1e8, 1e9))
        self.assertEqual(more_accurate_at_equal("hits", self.light, later), NOT_COMPARABLE)

    def test_several_intervals(self):
        found = intervals_below_zero(np.array([0.0, 1, 2, 3, 4]), np.array([-1.0, 1, -1, -1, 1]))
        self.assertEqual(found, [(None, 0.5), (1.5, 3.5)])

    def test_single_crossings_of_samples(self):
        found = single_crossings(np.array([0.0, 1, 2]), np.array([[1.0, -1, -1], [1, 1, 1], [1, -1, 1]]))
        self.assertEqual(found[0], 0.5)
        self.assertTrue(np.all(np.isnan(found[1:])))


class Front(unittest.TestCase):
    def test_only_runs_that_none_beats(self):
        cheap, good, worse, best = (
            exact_point("m", 1, e, s, 1) for e, s in ((0.5, 1), (0.2, 2), (0.3, 3), (0.1, 4))
        )
        self.assertEqual(pareto_front([best, worse, good, cheap], lambda p: p.seconds), [cheap, good, best])


class Charted(unittest.TestCase):
    def test_best_of_a_kind_is_compared_at_a_common_size(self):
        small, large = "photonmap/compact/r0.01/disc", "photonmap/compact/r0.02/disc"
        far = exact_curve(large, lambda h: 4e3 / h, lambda h: h, lambda h: h, sizes=(1e4, 1e5, 1e6))
        near = exact_curve(small, lambda h: 1e3 / h, lambda h: h, lambda h: h, sizes=(1e4, 1e5))
        found = groups([method_named(small), method_named(large)], {"cornell": {small: near, large: far}})
        self.assertEqual(found["methods"], [small])


if __name__ == "__main__":
    unittest.main()
