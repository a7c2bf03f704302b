"""Do two estimates of the same irradiances agree within their own variances?"""

from dataclasses import asdict, dataclass
from statistics import NormalDist

import numpy as np

# A right pair fails the mean of one channel with probability 0.27 %, and the same for all of its regions together.
LARGEST_Z = 3.0


def largest_region_z(count):
    chance = 2 * (1 - NormalDist().cdf(LARGEST_Z)) / count
    return NormalDist().inv_cdf(1 - chance / 2)


@dataclass(frozen=True)
class Agreement:
    points: int
    ours: float  # W/m^2, mean over points and channels
    theirs: float
    difference: float  # (ours - theirs) / theirs
    standard_error: float  # of `difference`
    z: float
    channel_z: list  # the same for R, G and B alone
    rms_z: float  # of single points and channels: about 1 if nothing differs and the variances are right
    region_rms_z: float  # of the means over regions: about 1, and blind neither to local errors nor to weak ones
    region_z: float  # the one of largest size
    region_z_bound: float  # that it must not exceed

    @property
    def verdict(self):
        mean_agrees = max(map(abs, [self.z, *self.channel_z])) <= LARGEST_Z
        return "agree" if mean_agrees and abs(self.region_z) <= self.region_z_bound else "DIFFER"

    def as_json(self):
        return {**asdict(self), "verdict": self.verdict}


def compare(ours, theirs, region_of):
    """`ours` and `theirs`: Estimate of the same points, independent of each other and from point to point.
    `region_of`: (points,) numbers of the regions of neighbouring points that are looked at by themselves."""
    difference = ours.irradiance - theirs.irradiance
    variance = ours.variance + theirs.variance
    mean, channel_error = difference.mean(axis=0), np.sqrt(variance.sum(axis=0)) / len(difference)
    # Channels vary together: of nearly grey light their mean has the mean of their standard errors, and never more.
    scale = theirs.irradiance.mean()
    point_z = _z(difference, variance)
    region_z = _z(_sums(difference, region_of), _sums(variance, region_of))
    return Agreement(
        points=len(difference),
        ours=float(ours.irradiance.mean()),
        theirs=float(scale),
        difference=float(mean.mean() / scale),
        standard_error=float(channel_error.mean() / scale),
        z=float(mean.mean() / channel_error.mean()),
        channel_z=(mean / channel_error).tolist(),
        rms_z=_rms(point_z),
        region_rms_z=_rms(region_z),
        region_z=float(region_z[np.argmax(np.abs(region_z))]),
        region_z_bound=largest_region_z(len(region_z)),
    )


def _sums(values, region_of):
    """(regions, 3)"""
    return np.stack([np.bincount(region_of, weights=channel) for channel in values.T], axis=1)


def _z(difference, variance):
    known = variance > 0
    return difference[known] / np.sqrt(variance[known])


def _rms(values):
    return float(np.sqrt(np.mean(values**2)))
