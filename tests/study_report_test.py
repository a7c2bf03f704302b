"""The study's report on synthetic studies whose errors are known. Bounds on random quantities come from SIGNIFICANCE."""

import contextlib
import io
import json
import math
import sys
import tempfile
import types
import unittest
from dataclasses import replace
from pathlib import Path
from statistics import NormalDist

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "bench" / "report"))

import numpy as np
import study_report
from study_bootstrap import CONFIDENCE, band, count_variance, counts, student_quantile
from study_crossings import (
    NOT_COMPARABLE,
    intervals_below_zero,
    more_accurate_at_equal,
    more_accurate_at_equal_bytes,
    single_crossings,
    smaller_at_equal_hits,
)
from study_curves import Curve, Point, curves_of
from study_data import Run, Study, StudyError
from study_errors import ErrorSplit, mean_products, reference_deviation, split
from study_front import pareto_front
from study_groups import groups
from study_images import same_bytes, same_time
from study_methods import FIXED_K, FIXED_RADIUS, GROWING_K, LIGHT_MAP, OTHER, parse
from study_slopes import slope_finding
from study_targets import AT_FIRST, BEYOND, NEVER, REACHED, bytes_to_reach, time_to_reach, winners
from synthetic_study import CONTEXT, REFERENCE_VARIANCE, Law, Plan, write_json, write_study

SIGNIFICANCE = 1e-6  # chance that a correct program fails one bound
SHLM, PHOTONS = "shlm/L2/radiance/knn4", "photonmap/flann/k50/disc"


def z_for(significance):
    """How many standard deviations a normal variable exceeds, to either side, with this probability."""
    return NormalDist().inv_cdf(1 - significance / 2)


def least_successes(trials, probability):
    """Fewer than this of `trials` have at most the probability SIGNIFICANCE: summed binomial distribution."""
    total = 0.0
    for successes in range(trials + 1):
        total += math.exp(
            math.lgamma(trials + 1)
            - math.lgamma(successes + 1)
            - math.lgamma(trials - successes + 1)
            + successes * math.log(probability)
            + (trials - successes) * math.log1p(-probability)
        )
        if total > SIGNIFICANCE:
            return successes
    return trials


def light_map_law(floor=1e-4, noise=1e3):
    return Law(lambda h: noise / h, lambda h: floor, lambda h: 1e-6 * h, bytes=lambda h: 32e6, texels=100)


def fixed_k_law(variance=0.02):
    return Law(lambda h: variance, lambda h: 10 / h, lambda h: 1e-6 * h, bytes=lambda h: 73 * h)


def growing_k_law():
    return Law(lambda h: 50 * h ** (-2 / 3), lambda h: 2 * h ** (-2 / 3), bytes=lambda h: 73 * h)


def radius_law():
    return Law(lambda h: 2e3 / h, lambda h: 4e-4, bytes=lambda h: 73 * h)


FOUR_METHODS = {
    SHLM: light_map_law(),
    PHOTONS: fixed_k_law(),
    "photonmap/flann/k0.05n23/cone": growing_k_law(),
    "photonmap/flann/r0.01/disc": radius_law(),
}


def exact_point(method, hits, error, seconds, size, bias_sq=0.0, seeds=4):
    """A measured point without noise: all resamples are the value itself."""
    rows = tuple(
        {
            "hits": hits,
            "seed": seed,
            "trace_seconds": seconds,
            "insert_seconds": 0.0,
            "build_seconds": 0.0,
            "gather_seconds": 0.0,
            "bytes": size,
            "texels": 10,
        }
        for seed in range(1, seeds + 1)
    )
    same = np.full(len(counts((1, 2))), 1.0)
    found = ErrorSplit(
        seeds, error, error, error - bias_sq, bias_sq, error * same, (error - bias_sq) * same, bias_sq * same
    )
    return Point(Run("scene", method, hits, rows), found, ())


def exact_curve(method, error_of, seconds_of, bytes_of, sizes=(1e4, 1e5, 1e6, 1e7), bias_sq=0.0):
    return Curve(
        parse(method),
        tuple(exact_point(method, h, error_of(h), seconds_of(h), bytes_of(h), bias_sq) for h in sizes),
    )


class Folder(unittest.TestCase):
    """A temporary folder for a test."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def report(self):
        """(exit code, stdout, stderr) of study_report.py on the folder."""
        out, errors = io.StringIO(), io.StringIO()
        arguments, sys.argv = sys.argv, ["study_report.py", str(self.folder)]
        try:
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
                code = study_report.main()
        finally:
            sys.argv = arguments
        return code, out.getvalue(), errors.getvalue()


class MethodNames(unittest.TestCase):
    def test_names_say_family_and_settings(self):
        found = parse("shlm/L4/normalised/bilinear/t65536")
        self.assertEqual(
            (found.family, found.order, found.weight, found.gather, found.texels),
            (LIGHT_MAP, 4, "normalised", "bilinear", 65536),
        )
        self.assertEqual(found.least_hits, 100)
        self.assertEqual(parse("shlm/L2/radiance/own/t64/h0").least_hits, 0)
        for name, family, number, kernel in (
            ("photonmap/flann/k50/disc", FIXED_K, 50, "disc"),
            ("photonmap/flann/k0.05n23/cone", GROWING_K, 0.05, "cone"),
            ("photonmap/flann/r0.01/epanechnikov", FIXED_RADIUS, 0.01, "epanechnikov"),
        ):
            found = parse(name)
            self.assertEqual((found.family, found.number, found.kernel), (family, number, kernel))
        self.assertEqual(parse("path tracing").family, OTHER)


class SettledPoints(unittest.TestCase):
    def test_are_those_whose_texels_show_their_own_hits(self):
        def point(hits):
            run = types.SimpleNamespace(rows=[{"texels": 1000}])
            return types.SimpleNamespace(hits=hits, run=run)

        points = tuple(point(hits) for hits in (1e4, 1e5, 1e6))
        for name, settled in (("shlm/L2/radiance/knn4", 2), ("shlm/L2/radiance/knn4/h10", 3), (PHOTONS, 3)):
            self.assertEqual(len(Curve(parse(name), points).settled_points), settled)


class Student(unittest.TestCase):
    def test_quantiles_of_the_tables(self):
        for degrees, value in ((1, 12.7062), (2, 4.3027), (7, 2.3646), (30, 2.0423)):
            self.assertAlmostEqual(student_quantile(0.975, degrees), value, delta=2e-4 * value)

    def test_variance_of_the_counts(self):
        for seeds in (2, 3, 4, 8):
            drawn = counts(tuple(range(seeds)))[:, 0]
            fourth = np.mean((drawn - 1) ** 4)
            bound = z_for(SIGNIFICANCE) * math.sqrt(fourth / len(drawn))
            self.assertAlmostEqual(np.mean((drawn - 1) ** 2), count_variance(seeds), delta=bound)

    def test_band_of_a_mean_is_that_of_student(self):
        for seeds in (2, 3, 8):
            values = np.random.default_rng(seeds).normal(size=seeds)
            drawn = counts(tuple(range(seeds))) @ values / seeds
            low, high = band(values.mean(), drawn, seeds)
            exact = student_quantile(0.975, seeds - 1) * values.std(ddof=1) / math.sqrt(seeds)
            kurtosis = np.mean((drawn - drawn.mean()) ** 4) / np.var(drawn) ** 2
            bound = z_for(SIGNIFICANCE) * math.sqrt(
                (kurtosis - 1) / 4 / len(drawn)
            )  # of a standard deviation
            self.assertAlmostEqual((high - low) / 2 / exact, 1, delta=bound)


class Split(unittest.TestCase):
    POINTS, VARIANCE, BIAS_SQ, OWN = 4000, 0.04, 0.0025, 0.0009

    def draw(self, generator, seeds, points):
        """Answers to a truth of one with a noisy reference: (answers, reference, weight)."""
        pattern = np.where(np.arange(points)[:, None] % 2 == 0, 1.0, -1.0)
        noise = generator.normal(size=(seeds, points, 3))
        answers = 1 + math.sqrt(self.BIAS_SQ) * pattern + math.sqrt(self.VARIANCE) * noise
        reference = 1 + math.sqrt(self.OWN) * generator.normal(size=(points, 3))
        return answers, reference, np.ones((points, 3))

    def test_recovers_variance_and_bias(self):
        seeds = 8
        answers, reference, weight = self.draw(np.random.default_rng(3), seeds, self.POINTS)
        found = split(mean_products(answers, reference, weight), self.OWN, tuple(range(seeds)))
        values, z = 3 * self.POINTS, z_for(SIGNIFICANCE)
        self.assertAlmostEqual(
            found.variance, self.VARIANCE, delta=z * self.VARIANCE * math.sqrt(2 / (seeds - 1) / values)
        )
        # bias^2 is the mean of (b + e)^2 less its expectation; e: noise of the mean and of the reference.
        noise_sq = self.VARIANCE / seeds + self.OWN
        deviation = math.sqrt(
            (4 * self.BIAS_SQ * noise_sq + 2 * noise_sq**2 + 2 * (self.VARIANCE / seeds) ** 2) / values
        )
        self.assertAlmostEqual(found.bias_sq, self.BIAS_SQ, delta=z * deviation)
        self.assertAlmostEqual(found.error, found.variance + found.bias_sq, places=15)

    def test_agrees_with_the_definitions(self):
        seeds = 5
        answers, reference, weight = self.draw(np.random.default_rng(4), seeds, 50)
        weight = weight / (reference**2 + 0.01)
        found = split(mean_products(answers, reference, weight), self.OWN, tuple(range(seeds)))
        variance = np.mean(np.var(answers, axis=0, ddof=1) * weight)
        bias_sq = np.mean((answers.mean(axis=0) - reference) ** 2 * weight) - variance / seeds - self.OWN
        self.assertAlmostEqual(found.mse, np.mean((answers - reference) ** 2 * weight), places=12)
        self.assertAlmostEqual(found.variance, variance, places=12)
        self.assertAlmostEqual(found.bias_sq, bias_sq, places=12)

    def test_bands_cover_the_truth(self):
        trials, points = 600, 60
        for seeds in (3, 8):
            covered = {"error": 0, "bias_sq": 0, "variance": 0}
            truth = {
                "error": self.VARIANCE + self.BIAS_SQ,
                "bias_sq": self.BIAS_SQ,
                "variance": self.VARIANCE,
            }
            generator = np.random.default_rng(seeds)
            for _ in range(trials):
                answers, _, weight = self.draw(generator, seeds, points)
                found = split(mean_products(answers, np.ones((points, 3)), weight), 0.0, tuple(range(seeds)))
                for name in covered:
                    low, high = getattr(found, name + "_band")
                    covered[name] += low <= truth[name] <= high
            for name, count in covered.items():
                self.assertGreaterEqual(
                    count, least_successes(trials, CONFIDENCE), f"{name} of {seeds} seeds"
                )
            # A mean of normal values has the exact interval: not too wide either.
            misses = trials - covered["error"]
            self.assertGreaterEqual(misses, least_successes(trials, 1 - CONFIDENCE), f"{seeds} seeds")

    def test_bands_cover_the_truth_beside_a_noisy_reference(self):
        # As noisy as the bias is large, so that its own noise is most of what is not known.
        trials, points, seeds, own = 600, 100, 8, 4 * self.BIAS_SQ
        truth = {"error": self.VARIANCE / 40 + self.BIAS_SQ, "bias_sq": self.BIAS_SQ}
        covered, without = dict.fromkeys(truth, 0), 0
        generator = np.random.default_rng(6)
        for _ in range(trials):
            pattern = np.where(np.arange(points)[:, None] % 2 == 0, 1.0, -1.0)
            answers = 1 + math.sqrt(self.BIAS_SQ) * pattern
            answers = answers + math.sqrt(self.VARIANCE / 40) * generator.normal(size=(seeds, points, 3))
            # All channels of a point alike, as from paths that are grey.
            reference = 1 + math.sqrt(own) * generator.normal(size=(points, 1)) * np.ones(3)
            weight = np.ones((points, 3))
            products, numbers = mean_products(answers, reference, weight), tuple(range(seeds))
            deviation = reference_deviation(answers, reference, weight, own * weight)
            found = split(products, own, numbers, deviation)
            for name in covered:
                low, high = getattr(found, name + "_band")
                covered[name] += low <= truth[name] <= high
            low, high = split(products, own, numbers).bias_sq_band
            without += low <= self.BIAS_SQ <= high
        for name, count in covered.items():
            self.assertGreaterEqual(count, least_successes(trials, CONFIDENCE), name)
        self.assertLess(without, least_successes(trials, CONFIDENCE), "the reference's noise is seen")

    def test_few_seeds(self):
        answers, reference, weight = self.draw(np.random.default_rng(5), 2, 100)
        alone = split(mean_products(answers[:1], reference, weight), self.OWN, (1,))
        self.assertTrue(math.isnan(alone.variance) and math.isnan(alone.bias_sq))
        self.assertIsNone(alone.error_band)
        pair = split(mean_products(answers, reference, weight), self.OWN, (1, 2))
        self.assertTrue(math.isfinite(pair.bias_sq))
        self.assertIsNone(pair.bias_sq_band)  # one pair of seeds says nothing of the spread of pairs
        low, high = pair.error_band
        self.assertTrue(low < pair.error < high)

    def test_no_band_where_too_few_resamples_have_a_value(self):
        samples = np.linspace(0.9, 1.1, 2000)
        samples[:100] = np.nan
        self.assertIsNone(band(1.0, samples, 8))


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
            ("photonmap/flann/k0.05n23/cone", -2 / 3),
            ("photonmap/flann/r0.01/disc", -1),
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
        found = self.findings({SHLM: light, "photonmap/flann/r0.01/disc": photons})["cornell"]
        for finding in found.values():
            # The clock's jitter of 3 %, over three decades.
            self.assertAlmostEqual(finding.over_seconds.value, finding.error.value, delta=0.01)
        self.assertIsNone(found[SHLM].over_bytes)
        radius = found["photonmap/flann/r0.01/disc"]
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
        name = "photonmap/flann/k0.05n23/disc"
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
            name: Law(lambda h: 1e3 / h, lambda h: 0.0) for name in (SHLM, "photonmap/flann/r0.01/disc")
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
            "photonmap/flann/k0.05n23/disc",
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
        small, large = "photonmap/flann/r0.01/disc", "photonmap/flann/r0.02/disc"
        far = exact_curve(large, lambda h: 4e3 / h, lambda h: h, lambda h: h, sizes=(1e4, 1e5, 1e6))
        near = exact_curve(small, lambda h: 1e3 / h, lambda h: h, lambda h: h, sizes=(1e4, 1e5))
        found = groups([small, large], {"cornell": {small: near, large: far}})
        self.assertEqual(found["methods"], [small])


class Reports(Folder):
    def test_whole_report(self):
        methods = {
            SHLM: light_map_law(),
            "shlm/L0/normalised/knn4": light_map_law(4e-4),
            "shlm/L2/radiance/knn4/t16384": light_map_law(1e-3, 100),
            PHOTONS: fixed_k_law(),
            "photonmap/flann/r0.01/disc": radius_law(),
        }
        plan = Plan(methods, scenes=("bumpy",), sizes=(10_000, 1_000_000), seeds=3, has_pictures=True)
        truth = write_study(self.folder, plan)["bumpy"]
        code, out, errors = self.report()
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual(sum(line.startswith("bumpy: 10 %: ") for line in out.splitlines()), 1)
        summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        scene = summary["scenes"]["bumpy"]
        self.assertEqual(summary["problems"], [])
        # The reference on disk is off by a thousandth at each value, and so are eps and the weights at most.
        bound = 2 * z_for(SIGNIFICANCE) * math.sqrt(REFERENCE_VARIANCE)
        self.assertAlmostEqual(scene["epsilon"] / truth.epsilon, 1, delta=bound)
        self.assertAlmostEqual(scene["reference_error_sq"] / REFERENCE_VARIANCE, 1, delta=bound)
        self.assertEqual(scene["seconds_to_reach"]["0.05"][PHOTONS]["kind"], "never")
        tilted = scene["methods"][SHLM][0]["tilt"]
        self.assertEqual([t["degrees"][0] for t in tilted], [0, 10, 20, 30, 40, 50, 60])
        text = (self.folder / "report.md").read_text(encoding="utf-8")
        for name in (
            "time-methods",
            "bytes-shlm",
            "hits-photonmap",
            "split-methods",
            "phases",
            "gather-methods",
            "tilt",
        ):
            self.assertTrue((self.folder / "charts" / f"{name}.png").exists(), name)
            self.assertIn(f"charts/{name}.png", text)
        self.assertIn("images/bumpy-same-time.png", text)
        self.assertTrue((self.folder / "images" / "bumpy-same-bytes.png").exists())
        for word in (CONTEXT["commit"], "3 seeds", "95 %", "2 threads", "eps = 0.01"):
            self.assertIn(word, text)

    def test_study_that_stopped_halfway(self):
        def seeds(method, hits):
            return (
                0
                if hits == 1_000_000 and method != SHLM
                else 1 if hits == 1_000_000 else 2 if method == PHOTONS else 3
            )

        methods = {SHLM: light_map_law(), PHOTONS: fixed_k_law()}
        write_study(
            self.folder, Plan(methods, sizes=(10_000, 100_000, 1_000_000), seeds_of=seeds, points=200)
        )
        document = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        rows, entries = document["rows"], document["scenes"]
        (self.folder / rows[0]["answers"]).unlink()
        with open(self.folder / rows[1]["answers"], "r+b") as file:
            file.truncate(100)
        rows.append(
            {"scene": "cornell", "method": PHOTONS, "hits_asked": 1_000_000, "skipped": "needs 12 GiB"}
        )
        rows.append(
            {"scene": "atrium", "method": SHLM, "hits_asked": 10_000, "seed": 1, "answers": "nowhere"}
        )
        entries["atrium"] = {"points": 10, "raw": "raw/atrium", "reference": "atrium.exr"}
        write_json(self.folder, rows, entries)
        code, out, errors = self.report()
        self.assertEqual((code, errors), (0, ""))
        text = (self.folder / "report.md").read_text(encoding="utf-8")
        self.assertIn("skipped: needs 12 GiB", text)
        summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(list(summary["scenes"]), ["cornell"])
        self.assertEqual(len(summary["problems"]), 3)  # a scene without a reference, two answers
        points = summary["scenes"]["cornell"]["methods"][SHLM]
        self.assertEqual([p["seeds"] for p in points], [1, 3, 1])
        self.assertIsNone(points[-1]["error_band"])
        self.assertIsNone(points[-1]["bias_sq"])

    def test_budgets_of_the_pictures(self):
        sizes = (10_000, 100_000, 1_000_000, 10_000_000)  # the last is over both budgets
        write_study(self.folder, Plan(FOUR_METHODS, sizes=sizes, seeds=1, points=100))
        curves = curves_of(Study(self.folder))["cornell"]
        self.assertEqual(same_time(curves).largest_within(curves[SHLM]).hits, 1_000_000)
        # 32e6 bytes: the photon map of a million hits is the first that is no smaller.
        smaller = same_bytes(curves)
        self.assertEqual(smaller.limit, 73e6)
        self.assertEqual(smaller.largest_within(curves[PHOTONS]).hits, 1_000_000)

    def test_bad_input_is_one_line(self):
        for content in (None, "{", '{"context": {}, "scenes": {}, "rows": []}', '{"rows": []}'):
            if content is not None:
                (self.folder / "study.json").write_text(content, encoding="utf-8")
            code, out, errors = self.report()
            self.assertEqual((code, out, errors.count("\n")), (2, "", 1), errors)
            self.assertFalse((self.folder / "report.md").exists())

    def test_a_reference_that_contradicts_its_files(self):
        write_study(self.folder, Plan({SHLM: light_map_law()}, sizes=(10_000,), seeds=1, points=50))
        document = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        document["scenes"]["cornell"]["reference_error"] = 0.5
        write_json(self.folder, document["rows"], document["scenes"])
        self.assertEqual(len(Study(self.folder).problems), 1)


class Broken(Folder):
    def test_missing_study(self):
        with self.assertRaises(StudyError):
            Study(self.folder / "nowhere")


if __name__ == "__main__":
    unittest.main()
