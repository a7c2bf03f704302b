"""Measures one scene by the program's own commands: what it is, a reference, the methods, what fit chooses.

All of it goes into the scene's folder of work, so that a run that was stopped goes on there.
"""

import json
import re
import signal
import subprocess
from dataclasses import asdict, dataclass
from pathlib import Path

REFERENCE_SIZE = (96, 54)
FIT_TARGET = "10%"


class SceneFailed(Exception):
    """The scene cannot be measured; one line."""


@dataclass(frozen=True)
class Settings:
    methods: str  # separated by commas
    hits: str
    seeds: int
    reference_until: str
    reference_seconds: float
    fit_seconds: float
    fit_max_hits: str

    def as_json(self):
        return asdict(self)


@dataclass(frozen=True)
class Ended:
    code: int
    out: str
    errors: str
    in_time: bool

    @property
    def last_line(self):
        """Why it failed, as the program says it, on one line."""
        lines = [line for line in (self.errors or self.out).splitlines() if line.strip()]
        return lines[-1].strip() if lines else f"ended with {self.code} and without a word"


def run(command, seconds=None):
    """Waits; after `seconds` asks the program to stop as Ctrl-C does, so that it keeps what it has."""
    with subprocess.Popen([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace") as process:
        try:
            out, errors = output_within(process, seconds)
            return Ended(process.returncode, out, errors, True)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            try:
                out, errors = process.communicate(timeout=300)
            except subprocess.TimeoutExpired:
                process.kill()
                out, errors = process.communicate()
            return Ended(process.returncode, out, errors, False)
        except KeyboardInterrupt:
            process.wait()  # has had the signal too
            raise


def output_within(process, seconds):
    return process.communicate(timeout=seconds)


class SceneRun:
    """The commands of one scene. Each method may raise SceneFailed."""

    def __init__(self, program, found, work, settings):
        self.program, self.found, self.work, self.settings = program, found, Path(work), settings

    @property
    def reference_file(self):
        return self.work / "references" / f"{self.found.file.stem}.exr"

    @property
    def study_folder(self):
        return self.work / "study"

    def info(self):
        ended = run([self.program, "info", self.found.file, "--json", *self.found.options])
        if ended.code != 0:
            raise SceneFailed(ended.last_line)
        return json.loads(ended.out)

    def reference(self):
        """What the program says of it: samples per pixel, relative error, warnings."""
        self.reference_file.parent.mkdir(parents=True, exist_ok=True)
        width, height = REFERENCE_SIZE
        command = [self.program, "reference", self.found.file, "--out", self.reference_file, "--width", width, "--height", height]
        ended = run([*command, "--until", self.settings.reference_until, *self.found.options], self.settings.reference_seconds)
        said = re.findall(r"(\d+) samples per pixel, relative error (\S+) %", ended.out + ended.errors)
        if not (ended.code == 0 or not ended.in_time) or not said or not self.reference_file.exists():
            raise SceneFailed(f"reference: {ended.last_line}")
        samples, percent = said[-1]
        return {"samples_per_pixel": int(samples), "relative_error": float(percent) / 100, "warnings": warnings_in(ended.errors)}

    def study(self):
        """Leaves study.json and the raw answers in study_folder."""
        command = [self.program, "study", self.found.file, "--references", self.reference_file.parent, "--out", self.study_folder]
        plan = ["--methods", self.settings.methods, "--hits", self.settings.hits, "--seeds", self.settings.seeds, "--anew"]
        ended = run([*command, *plan, *self.found.options])
        if ended.code != 0:
            raise SceneFailed(f"study: {ended.last_line}")

    def fit(self):
        """fit's own JSON, or {"reason": ...} where it gives none: that is an answer too."""
        seconds = self.settings.fit_seconds
        limits = ["--max-hits", self.settings.fit_max_hits, "--time", f"{seconds:g}s"]
        command = [self.program, "fit", self.found.file, "--target", FIT_TARGET, *limits, "--json"]
        # After its time it answers with what it knows, once the first pilot is there.
        ended = run([*command, *self.found.options], 3 * seconds)
        try:
            answer = json.loads(ended.out)
        except ValueError:
            return {"reason": ended.last_line if ended.in_time else f"no answer within {3 * seconds:g} s"}
        return answer[0] if isinstance(answer, list) else answer


def warnings_in(errors):
    """Without the scene's name, which each begins with."""
    return [line.split(": warning: ", 1)[1] for line in errors.splitlines() if ": warning: " in line]
