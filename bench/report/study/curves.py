"""Every method's measured sizes with their errors: what charts, tables and fits are made of."""

from dataclasses import dataclass

import numpy as np

from report.study.data import Run
from report.study.errors import ErrorSplit, split_of
from report.study.methods import Method
from report.study.tilt import split_by_tilt


@dataclass(frozen=True)
class Point:
    run: Run
    split: ErrorSplit
    tilted: tuple  # of TiltSplit, empty where the scene has no normal maps

    @property
    def hits(self):
        return self.run.median("hits")

    @property
    def seconds(self):
        """Total time until every point is answered: trace, insert, build, gather. Median over the seeds."""
        return float(np.median(self.run.total_seconds()))

    @property
    def bytes(self):
        """Of the finished map."""
        return self.run.median("bytes")


@dataclass(frozen=True)
class Curve:
    """One method in one scene, in ascending order of size."""

    method: Method
    points: tuple

    def array(self, name):
        return np.array([getattr(p, name) for p in self.points])

    @property
    def errors(self):
        return np.array([p.split.error for p in self.points])

    @property
    def texels(self):
        return self.points[0].run.rows[0].get("texels", 0)

    @property
    def settled_points(self):
        """Those at which more hits do not change what is gathered: a light map's blocks of texels shrink until then."""
        return [p for p in self.points if p.hits >= self.method.least_hits * self.texels]


def measure(scene, run, answers):
    return Point(run, split_of(scene, answers, run.seeds), split_by_tilt(scene, answers, run.seeds))


def curves_of(study):
    """scene -> name of the method -> Curve, in the order of the study."""
    found = {}
    for name, scene in study.scenes.items():
        points = {}
        for run, answers in study.runs(name):
            points.setdefault(run.method, []).append(measure(scene, run, answers))
        if points:
            found[name] = {m: Curve(study.method(m), tuple(points[m])) for m in study.methods if m in points}
    return found
