"""Where one method overtakes another. Between the measured sizes curves are straight in log-log."""

import math
from dataclasses import dataclass

import numpy as np

from report.study.bootstrap import band, exponentials
from report.study.targets import error_samples


@dataclass(frozen=True)
class Less:
    """Where `a` is below `b` in the range that both were measured in; None: an end of that range."""

    intervals: tuple  # of (low, high)
    range: tuple  # (low, high); None where there is no common range
    band: tuple = None  # of the crossing, where there is exactly one

    @property
    def always(self):
        return self.intervals == ((None, None),)

    @property
    def never(self):
        return self.range is not None and not self.intervals

    @property
    def crossing(self):
        """Where there is exactly one, else None."""
        ends = [end for interval in self.intervals for end in interval if end is not None]
        return ends[0] if len(ends) == 1 else None


NOT_COMPARABLE = Less((), None)


def common_grid(x_a, x_b):
    """Every measured size of both within the range of both, ascending; empty where that is less than two."""
    low, high = max(x_a.min(), x_b.min()), min(x_a.max(), x_b.max())
    grid = np.unique(np.concatenate([x_a, x_b, [low, high]]))
    grid = grid[(grid >= low) & (grid <= high)]
    return grid if len(grid) > 1 else np.array([])


def line_at(grid, x, values):
    """Rows of `values` (samples x sizes) at `grid`, straight between the sizes. `x` ascending."""
    right = np.clip(np.searchsorted(x, grid), 1, len(x) - 1)
    along = (grid - x[right - 1]) / (x[right] - x[right - 1])
    return values[:, right - 1] + along * (values[:, right] - values[:, right - 1])


def intervals_below_zero(x, difference):
    """Of the line through (x, difference)."""
    found, start, inside = [], None, difference[0] < 0
    for i in range(1, len(x)):
        if (difference[i] < 0) != inside:
            crossing = x[i - 1] + (x[i] - x[i - 1]) * difference[i - 1] / (difference[i - 1] - difference[i])
            if inside:
                found.append((start, float(crossing)))
            start, inside = float(crossing), not inside
    return found + [(start, None)] if inside else found


def single_crossings(x, differences):
    """Where each row (samples x len(x)) changes its sign; NaN unless it does so exactly once."""
    below = differences < 0
    changes = below[:, 1:] != below[:, :-1]
    at, rows = np.argmax(changes, axis=1), np.arange(len(below))
    left, right = differences[rows, at], differences[rows, at + 1]
    with np.errstate(invalid="ignore", divide="ignore"):
        crossing = x[at] + (x[at + 1] - x[at]) * left / (left - right)
    return np.where(changes.sum(axis=1) == 1, crossing, np.nan)


def less_on(log_x, difference, samples, seed_counts):
    """`difference`: log a - log b at log_x; `samples`: resamples x len(log_x); `seed_counts`: len(log_x)."""

    def back(x):
        return None if x is None else math.exp(x)

    intervals = tuple((back(low), back(high)) for low, high in intervals_below_zero(log_x, difference))
    result = Less(intervals, (math.exp(log_x[0]), math.exp(log_x[-1])))
    if result.crossing is None:
        return result
    log_crossing = math.log(result.crossing)
    right = int(np.clip(np.searchsorted(log_x, log_crossing), 1, len(log_x) - 1))
    fewest = int(min(seed_counts[right - 1], seed_counts[right]))
    return Less(
        intervals, result.range, exponentials(band(log_crossing, single_crossings(log_x, samples), fewest))
    )


@dataclass(frozen=True)
class Line:
    """A curve of errors over the logarithm of something, ascending; `samples`: resamples x sizes."""

    x: np.ndarray
    log_errors: np.ndarray
    samples: np.ndarray
    seed_counts: np.ndarray

    def at(self, grid):
        """(log errors, their samples, seed counts) at `grid`, from the two sizes around each point."""
        right = np.clip(np.searchsorted(self.x, grid), 1, len(self.x) - 1)
        counts = np.minimum(self.seed_counts[right - 1], self.seed_counts[right])
        return line_at(grid, self.x, self.log_errors[None, :])[0], line_at(grid, self.x, self.samples), counts


def line_over(column, curve):
    """Over "hits", "seconds" or "bytes". Sizes whose error is lost in the reference's noise are left out."""
    points = [p for p in curve.points if p.split.error > 0]
    points = list({getattr(p, column): p for p in sorted(points, key=lambda p: getattr(p, column))}.values())
    if len(points) < 2:
        return None
    samples = np.stack([error_samples(p) for p in points], axis=-1)
    return Line(
        np.log([getattr(p, column) for p in points]),
        np.log([p.split.error for p in points]),
        np.log(np.where(samples > 0, samples, np.nan)),
        np.array([p.split.seed_count for p in points]),
    )


def more_accurate_at_equal(column, curve, other):
    """Where the error of `curve` is below that of `other` at equal hits or seconds ("hits", "seconds")."""
    mine, theirs = line_over(column, curve), line_over(column, other)
    if mine is None or theirs is None or not len(grid := common_grid(mine.x, theirs.x)):
        return NOT_COMPARABLE
    my_logs, my_samples, my_counts = mine.at(grid)
    their_logs, their_samples, their_counts = theirs.at(grid)
    return less_on(
        grid, my_logs - their_logs, my_samples - their_samples, np.minimum(my_counts, their_counts)
    )


def more_accurate_at_equal_bytes(curve, other):
    """Where `curve`, whose bytes stay, beats the error `other` has at these bytes. In hits of `curve`."""
    own_bytes = math.log(float(np.median(curve.array("bytes"))))
    mine, theirs = line_over("hits", curve), line_over("bytes", other)
    if mine is None or theirs is None or not theirs.x[0] <= own_bytes <= theirs.x[-1]:
        return NOT_COMPARABLE
    logs, samples, counts = theirs.at(np.array([own_bytes]))
    return less_on(
        mine.x, mine.log_errors - logs, mine.samples - samples, np.minimum(mine.seed_counts, counts)
    )


def smaller_at_equal_hits(curve, other):
    """Where the finished map of `curve` takes fewer bytes than that of `other`."""
    x, x_other = np.log(curve.array("hits")), np.log(other.array("hits"))
    if len(x) < 2 or len(x_other) < 2 or not len(grid := common_grid(x, x_other)):
        return NOT_COMPARABLE
    mine = line_at(grid, x, np.log(curve.array("bytes"))[None, :])
    theirs = line_at(grid, x_other, np.log(other.array("bytes"))[None, :])
    return less_on(grid, (mine - theirs)[0], mine - theirs, np.ones(len(grid)))
