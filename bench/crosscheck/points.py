"""Surface points, and functions of Mitsuba's types over them. A variant must be set before this module is imported."""

from dataclasses import dataclass

import mitsuba as mi
import numpy as np


@dataclass(frozen=True)
class Points:
    """Where irradiance is asked for: (points, 3) each."""

    position: np.ndarray
    shading_normal: np.ndarray  # unit
    geometric_normal: np.ndarray  # unit, on the side that is asked about

    def __len__(self):
        return len(self.position)

    def every(self, step):
        return Points(self.position[::step], self.shading_normal[::step], self.geometric_normal[::step])


def lanes(points, repeats):
    """How many evaluations Mitsuba makes side by side: the wavefront size of a sampler."""
    return 1 if "scalar" in mi.variant() else len(points) * repeats


def mean_at(points, repeats, function):
    """(points, 3): mean over `repeats` calls of function(position, shading normal, geometric normal) -> mi.Color3f, which
    gets all points at once or, in the scalar variants, one at a time."""
    each = [points.position, points.shading_normal, points.geometric_normal]
    types = [mi.Point3f, mi.Vector3f, mi.Normal3f]
    if "scalar" in mi.variant():
        mean = np.zeros((len(points), 3))
        for i in range(len(points)):
            arguments = [make(vectors[i].tolist()) for make, vectors in zip(types, each)]
            mean[i] = np.mean([np.array(function(*arguments)) for _ in range(repeats)], axis=0)
        return mean
    columns = [np.repeat(vectors.astype(np.float32), repeats, axis=0).T for vectors in each]
    values = function(*(make(np.ascontiguousarray(column)) for make, column in zip(types, columns)))
    return np.array(values, dtype=np.float64).reshape(3, len(points), repeats).mean(axis=2).T
