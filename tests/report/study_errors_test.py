"""Bias, variance and their bands, on answers whose errors are known. Bounds on random quantities come from SIGNIFICANCE."""

import math
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

import numpy as np
from report.study.bootstrap import CONFIDENCE, band, count_variance, counts, student_quantile
from report.study.errors import mean_products, reference_deviation, split
from study_laws import SIGNIFICANCE, least_successes, z_for


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


if __name__ == "__main__":
    unittest.main()
