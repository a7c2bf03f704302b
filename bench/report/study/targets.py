"""What it costs to reach an error: time or bytes, interpolated between the measured sizes in log-log."""

import math
from dataclasses import dataclass

import numpy as np

from report.study.bootstrap import RESAMPLES, band, exponentials, resampled
from report.study.methods import FIXED_K

TARGETS = (0.10, 0.05, 0.02, 0.01)  # relative RMS error

REACHED = "reached"
AT_FIRST = "at the first size"  # already reached there: the cost is an upper bound
NEVER = "never"  # the part of the error that more hits do not lower exceeds the target
BEYOND = "beyond"  # neither reached nor forbidden


@dataclass(frozen=True)
class Reach:
    kind: str
    cost: float = math.nan
    band: tuple = None
    largest_hits: int = 0  # measured of this method

    @property
    def is_reached(self):
        return self.kind in (REACHED, AT_FIRST)


def costs_to_reach(costs, errors, target_sq):
    """Cost at which the error first falls to the target: NaN where it does not. Arrays: samples x sizes,
    ascending sizes.

    Between two sizes the error is a straight line in log-log.
    """
    low = target_sq * 1e-3  # differences with v_R may be zero or below
    log_errors, log_costs = np.log(np.maximum(errors, low)), np.log(costs)
    reached = errors <= target_sq
    first = np.argmax(reached, axis=1)
    rows, before = np.arange(len(errors)), np.maximum(first - 1, 0)
    step = log_errors[rows, before] - log_errors[rows, first]
    along = np.divide(
        log_errors[rows, before] - math.log(target_sq), step, out=np.zeros_like(step), where=step > 0
    )
    cost = np.exp(log_costs[rows, before] + along * (log_costs[rows, first] - log_costs[rows, before]))
    return np.where(reached.any(axis=1), cost, np.nan)


def floor(curve):
    """Low end of the band of the part that more hits do not lower, at the largest size that has a band; 0
    where there is none.

    It is bias^2 for light maps whose texels show their own hits and for fixed radii, the variance for fixed k; with
    growing k both fall.
    """
    for point in reversed(curve.settled_points):
        split = point.split
        found = (
            split.bias_sq_band
            if curve.method.has_floor
            else split.variance_band if curve.method.family == FIXED_K else None
        )
        if found:
            return found[0]
    return 0.0


def seconds_samples(point):
    """Median total time of each resample; constant with a single seed."""
    return np.median(point.run.total_seconds()[resampled(point.run.seeds)], axis=1)


def bytes_samples(point):
    return np.median(point.run.values("bytes")[resampled(point.run.seeds)], axis=1)


def error_samples(point):
    """Constant with a single seed."""
    samples = point.split.error_samples
    return samples if samples is not None else np.full(RESAMPLES, point.split.error)


def is_constant(costs):
    """A light map's bytes, but for the bookkeeping of FLANN's allocator."""
    return costs.size > 1 and costs.max() <= 1.01 * costs.min()


def reach(curve, target, cost_of, cost_samples_of):
    """`cost_of(point)` and `cost_samples_of(point)` say what is paid."""
    target_sq, largest = target**2, curve.points[-1].run.hits_asked
    costs = np.array([[cost_of(p) for p in curve.points]])
    cost = float(costs_to_reach(costs, curve.errors[None, :], target_sq)[0])
    if math.isnan(cost):
        return Reach(NEVER if floor(curve) > target_sq else BEYOND, largest_hits=largest)
    if curve.errors[0] <= target_sq and not is_constant(costs):
        return Reach(AT_FIRST, cost, largest_hits=largest)
    samples = costs_to_reach(
        np.stack([cost_samples_of(p) for p in curve.points], axis=-1),
        np.stack([error_samples(p) for p in curve.points], axis=-1),
        target_sq,
    )
    first = int(np.argmax(curve.errors <= target_sq))
    fewest = min(p.split.seed_count for p in curve.points[max(first - 1, 0) : first + 1])
    return Reach(REACHED, cost, exponentials(band(math.log(cost), np.log(samples), fewest)), largest)


def time_to_reach(curve, target):
    return reach(curve, target, lambda p: p.seconds, seconds_samples)


def bytes_to_reach(curve, target):
    return reach(curve, target, lambda p: p.bytes, bytes_samples)


def winners(reaches):
    """Names with the smallest cost, none where nobody reaches the target. `reaches`: name -> Reach."""
    costs = {name: r.cost for name, r in reaches.items() if r.is_reached}
    return [name for name, cost in costs.items() if cost <= min(costs.values()) * (1 + 1e-9)]


def may_be_as_good(reaches):
    """Names of those behind the winner whose band reaches down to the winner's."""
    first = winners(reaches)
    if not first or reaches[first[0]].band is None:
        return set()
    high = reaches[first[0]].band[1]
    return {
        name
        for name, r in reaches.items()
        if name not in first and r.is_reached and (r.band or (r.cost,))[0] <= high
    }
