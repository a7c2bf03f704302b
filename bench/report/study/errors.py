"""The error of one run: what more seeds would average out (variance) and what they would not (bias).

All means are over points and channels, relative to R^2 + eps. With the deviations of seed i,
D_i = (I_i - R) / sqrt(R^2 + eps), everything follows from the mean products G_ij = mean(D_i D_j):

    MSE      = mean of G_ii
    variance = mean of the unbiased variance over seeds
    bias^2   = mean((Ibar - R)^2 / (R^2 + eps)) - variance / S - v_R = mean of G_ij over i != j, minus v_R
    error    = MSE - v_R = variance + bias^2: against the truth, not against a noisy reference

bias^2 is an unbiased estimate and may come out below zero. The bootstrap needs G only. It takes bias^2 from
pairs of different seeds: a seed drawn twice would pass its noise off as bias. The reference's noise is the same
for all seeds; what is left of it once v_R is taken off widens the bands of error and bias^2.
"""

import math
from dataclasses import dataclass

import numpy as np

from report.study.bootstrap import band, counts, noise_of_no_seed, positive_band


@dataclass(frozen=True)
class ErrorSplit:
    """Samples: one value a resample, None with a single seed. Then variance and bias_sq are not a number."""

    seed_count: int
    mse: float
    error: float
    variance: float
    bias_sq: float
    error_samples: np.ndarray
    variance_samples: np.ndarray
    bias_sq_samples: np.ndarray

    @property
    def error_band(self):
        return positive_band(self.error, self.error_samples, self.seed_count)

    @property
    def variance_band(self):
        return (
            positive_band(self.variance, self.variance_samples, self.seed_count)
            if self.seed_count > 2
            else None
        )

    @property
    def bias_sq_band(self):
        """None for two seeds, a single pair. Where noise hides the bias it is up to sqrt(3) too wide."""
        return band(self.bias_sq, self.bias_sq_samples, self.seed_count) if self.seed_count > 2 else None

    @property
    def bias_share(self):
        """Of the error."""
        return max(0.0, self.bias_sq) / self.error if self.error > 0 else float("nan")


def mean_products(answers, reference, weight):
    """G: seeds x seeds, from answers (seeds x points x 3)."""
    scale = np.sqrt(weight / weight.size)
    deviations = ((answers - reference) * scale).reshape(len(answers), -1)
    return deviations @ deviations.T


def reference_deviation(answers, reference, weight, reference_variance):
    """Standard deviation of what the reference's noise n adds to MSE - v_R: mean of (n^2 - its mean) and of
    2 n bias. Points of a reference are independent, the channels of a point are taken to be one."""
    noise = np.sqrt(reference_variance * weight)
    bias = np.abs(answers.mean(axis=0) - reference) * np.sqrt(weight)
    of_square = math.sqrt(2) * np.sum(noise**2, axis=1)
    of_product = 2 * np.sum(noise * bias, axis=1)
    return math.sqrt(np.sum(of_square**2 + of_product**2)) / weight.size


def split_of(scene, answers, seeds, chosen=slice(None)):
    """The split over the chosen points of a scene; `answers`: seeds x points x 3."""
    reference, weight = scene.reference[chosen], scene.weight[chosen]
    variance, answers = scene.reference_variance[chosen], answers[:, chosen]
    return split(
        mean_products(answers, reference, weight),
        float(np.mean(variance * weight)),
        seeds,
        reference_deviation(answers, reference, weight, variance),
    )


def split(products, reference_error_sq, seeds, deviation=0.0):
    """`products` from mean_products, `reference_error_sq` is v_R, `seeds` a tuple of as many numbers,
    `deviation` from reference_deviation."""
    own = np.diag(products)
    count = len(seeds)
    mse = float(np.mean(own))
    error = mse - reference_error_sq
    if count < 2:
        return ErrorSplit(count, mse, error, float("nan"), float("nan"), None, None, None)

    def pair_mean(weights):
        """Weighted mean of G_ij over i != j; not a number where one seed was drawn alone."""
        total = weights.sum(axis=-1) ** 2 - (weights**2).sum(axis=-1)
        pairs = np.einsum("...i,ij,...j->...", weights, products - np.diag(own), weights)
        return np.divide(pairs, total, out=np.full_like(total, np.nan), where=total > 0)

    drawn = counts(seeds)
    bias_sq = float(pair_mean(np.ones(count))) - reference_error_sq
    shared = noise_of_no_seed(deviation, count) - reference_error_sq
    error_samples = drawn @ own / count + shared
    bias_sq_samples = pair_mean(drawn) + shared
    return ErrorSplit(
        count,
        mse,
        error,
        error - bias_sq,
        bias_sq,
        error_samples,
        error_samples - bias_sq_samples,
        bias_sq_samples,
    )
