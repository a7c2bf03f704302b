"""Confidence bands by bootstrap over the seeds, never over pixels: neighbouring pixels share photons.

The half width of a band is Student's t times the bootstrap's standard error, over sqrt(Var c), c being how
often one seed is drawn: a resample of few seeds spreads too little. For a mean of normal values this is the
exact interval at any number of seeds, where a percentile band of 8 seeds covers 89 % instead of 95 %. After
Efron and Tibshirani, "An Introduction to the Bootstrap" (1993), chapters 6 and 12.
"""

import math
from functools import lru_cache
from statistics import NormalDist

import numpy as np
from scipy.special import stdtrit

RESAMPLES = 2000
CONFIDENCE = 0.95
RANDOM_SEED = 2005
USABLE_SHARE = 0.975  # of the resamples must have a value, else there is no band


def is_one_seed(drawn):
    return (drawn == drawn[:, :1]).all(axis=1)


@lru_cache(maxsize=None)
def resampled(seeds):
    """RESAMPLES x len(seeds): positions in `seeds`. Runs with the same seeds share photons, hence draws.

    From three seeds on no resample consists of one seed alone: that would have no variance.
    """
    generator = np.random.default_rng([RANDOM_SEED, *seeds])
    drawn = generator.integers(0, len(seeds), (RESAMPLES, len(seeds)))
    while len(seeds) > 2 and (again := is_one_seed(drawn)).any():
        drawn[again] = generator.integers(0, len(seeds), (int(again.sum()), len(seeds)))
    return drawn


@lru_cache(maxsize=None)
def counts(seeds):
    """RESAMPLES x len(seeds): how often each seed was drawn."""
    return (resampled(seeds)[:, :, None] == np.arange(len(seeds))).sum(axis=1).astype(float)


@lru_cache(maxsize=None)
def student_quantile(probability, degrees_of_freedom):
    """Of Student's t."""
    return float(stdtrit(degrees_of_freedom, probability))


def count_variance(seed_count):
    """Var c, of how often one seed is in a resample; from three seeds on without those of one seed alone."""
    lone = seed_count ** (1 - seed_count) if seed_count > 2 else 0.0
    return ((seed_count - 1) / seed_count - lone * (seed_count - 1)) / (1 - lone)


def half_width(samples, seed_count):
    """None where too few resamples have a value."""
    usable = samples[np.isfinite(samples)]
    if len(usable) < USABLE_SHARE * len(samples):
        return None
    student = student_quantile(0.5 + 0.5 * CONFIDENCE, seed_count - 1)
    return student * float(np.std(usable)) / math.sqrt(count_variance(seed_count))


@lru_cache(maxsize=None)
def normal_draws():
    return np.random.default_rng([RANDOM_SEED, 0]).normal(size=RESAMPLES)


def noise_of_no_seed(deviation, seed_count):
    """RESAMPLES values to add to samples, for noise of this known standard deviation that all seeds share: alone they
    give a band of CONFIDENCE. The same draws each time, for what is shared by all methods, too."""
    usual = NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE)
    student = student_quantile(0.5 + 0.5 * CONFIDENCE, seed_count - 1)
    return normal_draws() * (deviation * usual * math.sqrt(count_variance(seed_count)) / student)


def band(value, samples, seed_count):
    """(low, high), or None where there are fewer than two seeds or too few resamples have a value."""
    if samples is None or seed_count < 2 or not math.isfinite(value):
        return None
    half = half_width(samples, seed_count)
    return half if half is None else (value - half, value + half)


def positive_band(value, samples, seed_count):
    """The same for what cannot be negative: in the logarithm, unless noise brings it to zero or below."""
    if samples is None or value <= 0 or not np.all(samples[np.isfinite(samples)] > 0):
        plain = band(value, samples, seed_count)
        return plain and (min(value, max(0.0, plain[0])), plain[1])
    return exponentials(band(math.log(value), np.log(samples), seed_count))


def exponentials(logs):
    """Of a band of logarithms; two seeds that differ much have one that no float can hold."""
    return logs and (math.exp(max(logs[0], -700.0)), math.exp(min(logs[1], 700.0)))
