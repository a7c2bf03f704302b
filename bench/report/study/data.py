"""What `shlmbench study` has measured, read back; a study that was stopped halfway has fewer rows."""

import json
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from report.study.methods import method_of

PHASES = ("trace", "insert", "build", "gather")
EPSILON_SHARE = 0.01  # eps = this x (mean of R)^2


class StudyError(Exception):
    """The folder holds no study that can be read; one line."""


@dataclass(frozen=True)
class Run:
    """One method at one size: the measured rows, one a seed, in ascending order of seed."""

    scene: str
    method: str
    hits_asked: int
    rows: tuple

    @property
    def seeds(self):
        return tuple(row["seed"] for row in self.rows)

    def values(self, column):
        return np.array([row[column] for row in self.rows], dtype=float)

    def median(self, column):
        return float(np.median(self.values(column)))

    def has(self, column):
        """Older tables lack some."""
        return all(column in row for row in self.rows)

    @property
    def flip(self):
        """Of the picture, which the first seed has; None without one."""
        return next((row["flip"] for row in self.rows if "flip" in row), None)

    def total_seconds(self):
        """One value a seed: from the first photon until every point is answered, wall time."""
        return sum(self.values(phase + "_seconds") for phase in PHASES)


@dataclass(frozen=True)
class Scene:
    """The truth about one scene. points x 3 (W/m^2), but `tilt` (degrees) and `pixel` (y width + x)."""

    name: str
    reference: np.ndarray
    reference_variance: np.ndarray  # of the reference's mean
    tilt: np.ndarray
    pixel: np.ndarray
    epsilon: float  # (W/m^2)^2
    weight: np.ndarray  # 1 / (R^2 + eps)

    @property
    def points(self):
        return len(self.reference)

    @property
    def reference_error_sq(self):
        """v_R: relative variance of the reference itself, mean over points and channels."""
        return float(np.mean(self.reference_variance * self.weight))


def read_array(path, kind, shape):
    values = np.fromfile(path, dtype=kind)
    if values.size != np.prod(shape):
        raise StudyError(f"{path} holds {values.size} values instead of {int(np.prod(shape))}")
    return values.reshape(shape)


def read_scene(folder, name, entry):
    """Raises StudyError or OSError where a file is missing or has another size."""
    points, raw = entry["points"], folder / entry["raw"]
    reference = read_array(raw / "reference.f32", "<f4", (points, 3)).astype(float)
    epsilon = EPSILON_SHARE * float(np.mean(reference)) ** 2
    return Scene(
        name,
        reference,
        read_array(raw / "variance.f32", "<f4", (points, 3)).astype(float),
        read_array(raw / "tilt.f32", "<f4", (points,)).astype(float),
        read_array(raw / "pixel.u32", "<u4", (points,)),
        epsilon,
        1.0 / (reference**2 + epsilon),
    )


class Study:
    """The rows of one study.json. `problems` collects what had to be left out, a line each."""

    def __init__(self, folder):
        self.folder = Path(folder)
        try:
            with open(self.folder / "study.json", encoding="utf-8") as file:
                document = json.load(file)
            self.context, self._entries, self.rows = document["context"], document["scenes"], document["rows"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise StudyError(f"{self.folder / 'study.json'} cannot be read: {error}") from error
        self.problems = []
        self.scenes = {}
        for name, entry in self._entries.items():
            try:
                self.scenes[name] = read_scene(self.folder, name, entry)
            except (OSError, StudyError) as error:
                self.problems.append(f"scene {name} is left out: {error}")
                continue
            self._check_reference(self.scenes[name], entry.get("reference_error"))

    def _check_reference(self, scene, written):
        """The writer has the same definition of the reference's own error, or one of us is wrong."""
        own = scene.reference_error_sq**0.5
        if written is not None and abs(own - written) > 0.01 * max(own, written):
            self.problems.append(
                f"scene {scene.name}: study.json gives the reference an error of {written:.3g}, its files "
                f"{own:.3g}"
            )

    @property
    def methods(self):
        return list(dict.fromkeys(row["method"] for row in self.rows))

    def method(self, name):
        """What its rows say that it is."""
        return method_of(next(row for row in self.rows if row["method"] == name))

    def entry(self, scene):
        """What study.json says of the scene."""
        return self._entries[scene]

    def scene_folder(self, scene):
        """Relative to the study's folder."""
        return self._entries[scene]["raw"]

    def skipped(self, scene):
        """(method, hits asked for, reason), each once."""
        found = [
            (r["method"], r["hits_asked"], r["skipped"])
            for r in self.rows
            if r["scene"] == scene and "skipped" in r
        ]
        return list(dict.fromkeys(found))

    def answers(self, row):
        """Irradiance, points x 3."""
        return read_array(self.folder / row["answers"], "<f4", (self.scenes[row["scene"]].points, 3))

    def _measured_with_answers(self, row):
        try:
            if np.all(np.isfinite(answers := self.answers(row))):
                return answers
            reason = "not all its values are finite"
        except (OSError, StudyError) as error:
            reason = str(error)
        self.problems.append(
            f"{row['scene']} {row['method']} {row['hits_asked']} seed {row['seed']} is left out: {reason}"
        )
        return None

    def runs(self, scene):
        """Yields (Run, answers: seeds x points x 3) one by one: together they may exceed the memory."""
        by_run = defaultdict(dict)
        for row in self.rows:
            if row["scene"] == scene and "skipped" not in row:
                by_run[row["method"], row["hits_asked"]][row["seed"]] = row
        for (method, hits), by_seed in sorted(by_run.items()):
            found = [(by_seed[seed], self._measured_with_answers(by_seed[seed])) for seed in sorted(by_seed)]
            found = [(row, answers) for row, answers in found if answers is not None]
            if found:
                yield Run(scene, method, hits, tuple(row for row, _ in found)), np.stack(
                    [a for _, a in found]
                )
