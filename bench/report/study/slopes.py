"""How fast the error falls with the hits: the slope of log(error) over log(hits), against theory.

Which sizes count (at least two, with at least two seeds each):
- light maps and fixed radii: where the variance is at least 4 x bias^2, for theory speaks of the way to the
  floor; of light maps those at which texels show their own hits;
- photon maps with fixed or growing k: all from 1e5 hits on;
- others: all.
The variance alone is fitted over all sizes, or for photon maps with fixed or growing k from 1e5 hits on.
"""

from dataclasses import dataclass

import numpy as np

from report.study.bootstrap import band
from report.study.methods import FIXED_K, GROWING_K, SLOPE_OF_THEORY, THEORY_TEXT

VARIANCE_OVER_BIAS = 4.0
FIRST_HITS = 1e5
FEWEST_SIZES = 2
LEAST_GROWTH = 0.1  # of the logarithm: the bytes of a light map vary by FLANN's bookkeeping


@dataclass(frozen=True)
class Slope:
    value: float
    band: tuple  # (low, high) or None
    sizes: int

    def agrees_with(self, theory):
        return self.band is not None and self.band[0] <= theory <= self.band[1]


@dataclass(frozen=True)
class SlopeFinding:
    error: Slope  # None where too few sizes are left
    variance: Slope
    theory: float  # None where theory says nothing; the same for error and variance
    theory_text: str
    verdict: str
    over_seconds: Slope  # of the error over the total time and over the bytes, the same sizes
    over_bytes: Slope  # None where the bytes do not grow


def least_squares(log_hits, logs):
    """Slopes; `logs` is sizes, or samples x sizes."""
    centred = log_hits - log_hits.mean()
    return (logs - logs.mean(axis=-1, keepdims=True)) @ centred / (centred @ centred)


def fit(points, value_of, samples_of, cost_of=lambda p: p.hits):
    """Slope of value_of(split) over the cost of the points; None where fewer than two can be used or the cost
    stays the same."""
    usable = [p for p in points if p.split.seed_count > 1 and value_of(p.split) > 0]
    if len(usable) < FEWEST_SIZES:
        return None
    log_costs = np.log([cost_of(p) for p in usable])
    if log_costs.max() - log_costs.min() < LEAST_GROWTH:
        return None
    value = float(least_squares(log_costs, np.log([value_of(p.split) for p in usable])))
    samples = np.stack([samples_of(p.split) for p in usable], axis=-1)
    logs = np.log(np.where(samples > 0, samples, np.nan))
    fewest = min(p.split.seed_count for p in usable)
    return Slope(value, band(value, least_squares(log_costs, logs), fewest), len(usable))


def from_first_hits(curve):
    return [p for p in curve.points if p.run.hits_asked >= FIRST_HITS]


def above_floor(curve):
    return [p for p in curve.settled_points if p.split.variance >= VARIANCE_OVER_BIAS * p.split.bias_sq]


def fitted_points(curve):
    """(for the error, for the variance alone)"""
    if curve.method.family in (FIXED_K, GROWING_K):
        return from_first_hits(curve), from_first_hits(curve)
    return above_floor(curve) if curve.method.has_floor else curve.points, curve.settled_points


def verdict(curve, points, error, variance, theory):
    if theory is None or error is None or error.band is None:
        return "-"
    if error.agrees_with(theory):
        return "agrees within its interval"
    shares = [p.split.bias_share for p in points if p.split.seed_count > 1]
    first, last = 100 * shares[0], 100 * shares[-1]
    why = f"bias² is {first:.0f} % of the error at the first size fitted, {last:.0f} % at the last"
    if variance is not None and variance.agrees_with(theory):
        return f"the variance alone agrees; the error differs by {error.value - theory:+.3f}: {why}"
    return f"no, by {error.value - theory:+.3f}: {why}"


def slope_finding(curve):
    for_error, for_variance = fitted_points(curve)

    def of_error(*cost_of):
        return fit(for_error, lambda s: s.error, lambda s: s.error_samples, *cost_of)

    error = of_error()
    variance = fit(for_variance, lambda s: s.variance, lambda s: s.variance_samples)
    theory = SLOPE_OF_THEORY.get(curve.method.family)
    return SlopeFinding(
        error,
        variance,
        theory,
        THEORY_TEXT.get(curve.method.family, "-"),
        verdict(curve, for_error, error, variance, theory),
        of_error(lambda p: p.seconds),
        of_error(lambda p: p.bytes),
    )
