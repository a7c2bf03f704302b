"""The three things that are measured of two revisions. Each writes its rows as it goes, so that an interruption keeps what is finished."""

from statistics import median

import alternation
import instructions
import interval
import micro
import render_errors
from process import MeasurementFailed
from progress import say

SLOWER_OR_FASTER = {1: "slower", -1: "faster", 0: "same"}
WORSE_OR_BETTER = {1: "worse", -1: "better", 0: "same"}


def row_of(base, head, comparisons, band, words):
    """`band` in the logarithm of the ratio; None where the noise is just being learnt."""
    found = interval.ratio(base, head, comparisons)
    return {
        "base": median(base),
        "head": median(head),
        "ratio": found.value,
        "interval": [found.low, found.high],
        "band": band,
        "verdict": "learnt" if band is None else words[interval.side(found, band)],
    }


def failed(failure):
    return {"verdict": "failed", "because": str(failure)}


def measure_times(programs, names, pairs, bands, rows):
    """rows[name]: seconds of one iteration, their ratio HEAD / BASE with its interval, the band and the verdict."""
    for number, name in enumerate(names, 1):
        say(f"time {number}/{len(names)} {name}")
        try:
            base, head = alternation.alternate(lambda program: micro.seconds(program, name), programs, pairs)
            rows[name] = row_of(base, head, len(names), bands.get(name), SLOWER_OR_FASTER)
        except MeasurementFailed as failure:
            rows[name] = failed(failure)


def measure_errors(programs, cases, rows):
    """rows["SCENE/METHOD"]: relative RMS errors, in the same way. The same seed gives the same image, so their band is 0."""
    for number, case in enumerate(cases, 1):
        name = case[0]
        say(f"error {number}/{len(cases)} {name}")
        try:
            base, head = (
                [render_errors.relative_rms(program, programs[1], case, seed) for seed in render_errors.SEEDS]
                for program in programs
            )
            rows[name] = row_of(base, head, len(cases), 0.0, WORSE_OR_BETTER)
        except MeasurementFailed as failure:
            rows[name] = failed(failure)


def count_instructions(programs, folder, rows):
    """rows[name]["instructions"]: of one iteration, [BASE, HEAD], None where callgrind cannot run the benchmark."""

    def count_or_none(program, name):
        try:
            return instructions.count(program, name, folder / "callgrind.out")
        except MeasurementFailed as failure:
            say(f"no instruction count of {name}: {failure}")
            return None

    chosen = [name for name, row in rows.items() if "ratio" in row and instructions.is_countable(name)]
    for number, name in enumerate(chosen, 1):
        say(f"instructions {number}/{len(chosen)} {name}")
        rows[name]["instructions"] = [count_or_none(program, name) for program in programs]
