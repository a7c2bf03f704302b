"""Makes random rooms and their references, fits them, and verifies what was chosen with other seeds."""

import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path


REFERENCE_SIZE = (256, 144)  # seven times as many points as a fit looks at


class PromiseError(Exception):
    """One line."""


@dataclass(frozen=True)
class Settings:
    program: str  # shlmbench
    maker: str  # shlmbench_scenes
    targets: str  # "20%,10%,5%"
    max_hits: str
    seeds: int  # of each verification
    reference_until: str
    time: str  # of each search

    def fit_words(self):
        limits = ["--max-hits", self.max_hits, "--seeds", str(self.seeds)]
        return ["--target", self.targets, "--least", "time", *limits, *(["--time", self.time] if self.time else [])]


def run(*words):
    ended = subprocess.run([str(word) for word in words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if ended.returncode == 130:
        raise KeyboardInterrupt
    if ended.returncode != 0:
        lines = [line for line in ended.stderr.splitlines() if line.strip()]
        raise PromiseError(lines[-1] if lines else f"{words[0]} ended with {ended.returncode}")


def fits_of(room, settings, work):
    """The fits of one room, by target: made where they are not there yet."""
    work = Path(work)
    scene, reference, out = work / f"{room}.glb", work / f"{room}.exr", work / "fits" / room
    done = out / "done"  # the last thing that is written
    if not done.exists():
        run(settings.maker, work, room)
        width, height = REFERENCE_SIZE
        run(settings.program, "reference", scene, "--until", settings.reference_until, "--width", width, "--height", height, "--out", reference)
        run(settings.program, "fit", scene, *settings.fit_words(), "--verify", reference, "--out", out)
        done.write_text("")
    return [json.loads(file.read_text()) for file in sorted(out.glob("**/fit.json"))]


def all_fits(first, count, settings, work):
    for room in range(first, first + count):
        print(f"room-{room}: {room - first + 1} of {count}", file=sys.stderr, flush=True)
        yield from fits_of(f"room-{room}", settings, work)
