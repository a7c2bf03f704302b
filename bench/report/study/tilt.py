"""Error by tilt: the angle between the shading normal, bent by a normal map, and the geometric normal."""

from dataclasses import dataclass

import numpy as np

from report.study.errors import ErrorSplit, split_of

EDGES = (0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 90.0)  # degrees
FEWEST_POINTS = 30  # a bin with fewer says nothing about its angle


@dataclass(frozen=True)
class TiltSplit:
    low: float
    high: float
    points: int
    split: ErrorSplit

    @property
    def label(self):
        return f"{self.low:.0f}+" if self.high == EDGES[-1] else f"{self.low:.0f}-{self.high:.0f}"


def is_tilted(scene):
    return int(np.sum(scene.tilt >= EDGES[1])) >= FEWEST_POINTS


def split_by_tilt(scene, answers, seeds):
    """A TiltSplit per bin with enough points, none without normal maps. `answers`: seeds x points x 3."""
    if not is_tilted(scene):
        return ()
    found = []
    for low, high in zip(EDGES[:-1], EDGES[1:]):
        chosen = (scene.tilt >= low) & ((scene.tilt < high) | (high == EDGES[-1]))
        if np.sum(chosen) >= FEWEST_POINTS:
            found.append(TiltSplit(low, high, int(np.sum(chosen)), split_of(scene, answers, seeds, chosen)))
    return tuple(found)
