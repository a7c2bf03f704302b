"""How much larger HEAD is than BASE: a ratio with a bootstrap interval over pairs of runs.

The ratio is the geometric mean of the pairs' ratios, the largest and the smallest fifth left out: on a machine with other work
some runs are slow by much. Its interval is Student's t times the bootstrap's standard error, in the logarithm. A percentile
interval of ten pairs cannot do this: corrected for dozens of benchmarks it would have to reach beyond the
largest ratio seen. Between equal programs pairs alternate, so their ratios scatter alike to both sides, for which t is safe
also where they have long tails (simulated in tests/report/track_statistics_test.py).
"""

import math
from dataclasses import dataclass

import numpy as np
from report.study.bootstrap import student_quantile

CONFIDENCE = 0.95  # that all intervals of a table together hold what they estimate
RESAMPLES = 2000
RANDOM_SEED = 2005
TRIMMED = 0.2  # at each end


@dataclass(frozen=True)
class Ratio:
    value: float
    low: float
    high: float


def trimmed_mean(values):
    """Along the last axis."""
    cut = int(TRIMMED * values.shape[-1])
    return np.sort(values, axis=-1)[..., cut : values.shape[-1] - cut].mean(axis=-1)


def standard_error(values):
    count = len(values)
    drawn = np.random.default_rng(RANDOM_SEED).integers(0, count, (RESAMPLES, count))
    # A resample's variance is (count - 1) / count of the unbiased one.
    return float(np.std(trimmed_mean(values[drawn]))) * math.sqrt(count / (count - 1))


def ratio(base, head, comparisons):
    """`comparisons`: the number of intervals that are looked at together (Bonferroni)."""
    logs = np.log(np.asarray(head, dtype=float) / np.asarray(base, dtype=float))
    centre = float(trimmed_mean(logs))
    student = student_quantile(1 - 0.5 * (1 - CONFIDENCE) / comparisons, len(logs) - 1)
    half = student * standard_error(logs)
    return Ratio(math.exp(centre), math.exp(centre - half), math.exp(centre + half))


def side(found, band):
    """1 where the interval lies above 1 by more than the band (of the logarithm), -1 where below, else 0."""
    if math.log(found.low) > band:
        return 1
    return -1 if math.log(found.high) < -band else 0
