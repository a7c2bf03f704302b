"""What the tests of the study's report share: laws of error with known answers, bounds on random quantities."""

import math
import tempfile
import unittest
from pathlib import Path
from statistics import NormalDist

import numpy as np
from report.study.bootstrap import counts
from report.study.curves import Curve, Point
from report.study.data import Run
from report.study.errors import ErrorSplit
from report.study.methods import method_of
from synthetic_study import Law
from known_methods import facts_of

SIGNIFICANCE = 1e-6  # chance that a correct program fails one bound
SHLM, PHOTONS = "shlm/L2/radiance/surface4", "photonmap/compact/k50/disc"


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
    "photonmap/compact/k0.05n23/cone": growing_k_law(),
    "photonmap/compact/r0.01/disc": radius_law(),
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
        method_of(facts_of(method)),
        tuple(exact_point(method, h, error_of(h), seconds_of(h), bytes_of(h), bias_sq) for h in sizes),
    )


class Folder(unittest.TestCase):
    """A temporary folder for a test."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
