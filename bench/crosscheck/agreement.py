"""Do two estimates of the same irradiances agree within their own variances?"""

from dataclasses import asdict, dataclass

import numpy as np

# A right pair fails one channel with probability 0.27 %.
LARGEST_Z = 3.0


@dataclass(frozen=True)
class Agreement:
    points: int
    ours: float  # W/m^2, mean over points and channels
    theirs: float
    difference: float  # (ours - theirs) / theirs
    standard_error: float  # of `difference`
    z: float
    channel_z: list  # the same for R, G and B alone
    rms_z: float  # over points and channels: about 1 if the variances are right and nothing else differs
    share_beyond_3: float  # of them; 0.0027 for normal variables

    @property
    def verdict(self):
        return "agree" if max(map(abs, [self.z, *self.channel_z])) <= LARGEST_Z else "DIFFER"

    def as_json(self):
        return {**asdict(self), "verdict": self.verdict}


def compare(ours, theirs):
    """`ours` and `theirs`: Estimate of the same points, independent of each other and from point to point."""
    count = len(ours.irradiance)
    difference = ours.irradiance - theirs.irradiance
    variance = ours.variance + theirs.variance
    mean, channel_error = difference.mean(axis=0), np.sqrt(variance.sum(axis=0)) / count
    # Channels vary together: of nearly grey light, their mean has the mean of their standard errors, and never more.
    scale = theirs.irradiance.mean()
    known = variance > 0
    z = difference[known] / np.sqrt(variance[known])
    return Agreement(
        points=count,
        ours=float(ours.irradiance.mean()),
        theirs=float(scale),
        difference=float(mean.mean() / scale),
        standard_error=float(channel_error.mean() / scale),
        z=float(mean.mean() / channel_error.mean()),
        channel_z=(mean / channel_error).tolist(),
        rms_z=float(np.sqrt(np.mean(z**2))),
        share_beyond_3=float(np.mean(np.abs(z) > 3)),
    )
