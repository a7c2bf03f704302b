"""How far each method's answers are from the reference, in the mean and in each part of the picture.

Errors are of the mean of all seeds. A region is a square of 8 x 8 points; it is filled if every one of them lies on a surface. Chance
in sums of answers is measured by what seeds differ by: its variance grows with the sum, as photons are counted, so that all regions
together say what one has.
"""

import math
from dataclasses import asdict, dataclass
from statistics import NormalDist

import numpy as np

REGION = 8  # points along each side
LARGEST_Z = 3.0  # a right method passes it once in 370
PASSED, MISSED, UNDECIDED = "within", "MISSED", "within chance"


@dataclass(frozen=True)
class Error:
    """Of a sum of answers, relative to that of the reference; signed: too bright is positive."""

    value: float
    chance: float  # its standard error; NaN with a single seed

    def judged(self, bound, largest_z=LARGEST_Z):
        if abs(self.value) <= bound:
            return PASSED
        chance = 0 if math.isnan(self.chance) else self.chance
        return MISSED if abs(self.value) - largest_z * chance > bound else UNDECIDED


@dataclass(frozen=True)
class Figures:
    mean: Error
    rms: float  # relative, of single points, mean over seeds, without the reference's noise
    worst_region: Error | None  # the filled one that is furthest off; None where none is filled
    surest_region: Error | None  # the one that is furthest off by more than chance
    regions: int  # filled ones
    region_z: float  # that chance passes in one of them once in 370

    def as_json(self):
        return asdict(self)


def figures(scene, answers, width):
    """`scene`: study_data.Scene; `answers`: seeds x points x 3."""
    region_of, sizes = regions(scene.pixel, width)
    truth = _sums(scene.reference, region_of, len(sizes))
    measured = np.stack([_sums(values, region_of, len(sizes)) for values in answers])
    noise = np.sqrt(_sums(scene.reference_variance, region_of, len(sizes)))  # the reference's own
    per_light = _variance_per_light(measured, truth)
    chance = np.sqrt(per_light * truth / len(answers) + noise**2)
    difference = measured.mean(axis=0) - truth
    whole = Error(
        float(difference.sum() / truth.sum()),
        float(np.sqrt(per_light * truth.sum() / len(answers) + (noise**2).sum()) / truth.sum()),
    )
    filled = np.flatnonzero((sizes == REGION * REGION) & (truth > 0))
    off, by_chance = difference[filled] / truth[filled], chance[filled] / truth[filled]
    most = region_z(len(filled))
    worst = _largest(np.abs(off), off, by_chance)
    surest = _largest(np.abs(off) - most * np.nan_to_num(by_chance), off, by_chance)
    squares = [np.mean((values - scene.reference) ** 2 * scene.weight) for values in answers]
    rms = math.sqrt(max(0.0, float(np.mean(squares)) - scene.reference_error_sq))
    return Figures(whole, rms, worst, surest, len(filled), most)


def regions(pixel, width):
    """(number of each point's region, points of each region); regions without points have no number."""
    y, x = pixel.astype(int) // width, pixel.astype(int) % width
    square = y // REGION * (-(-width // REGION)) + x // REGION
    _, region_of, sizes = np.unique(square, return_inverse=True, return_counts=True)
    return region_of, sizes


def region_z(count):
    """What the largest of `count` right regions passes as rarely as one passes LARGEST_Z."""
    chance = 2 * (1 - NormalDist().cdf(LARGEST_Z)) / max(count, 1)
    return NormalDist().inv_cdf(1 - chance / 2)


def _largest(key, values, chances):
    if len(key) == 0:
        return None
    i = int(np.argmax(key))
    return Error(float(values[i]), float(chances[i]))


def _sums(values, region_of, count):
    return np.bincount(region_of, weights=np.asarray(values, float).sum(axis=1), minlength=count)


def _variance_per_light(measured, truth):
    if len(measured) < 2:
        return math.nan
    lit = truth > 0
    return float(np.mean(measured.var(axis=0, ddof=1)[lit] / truth[lit]))
