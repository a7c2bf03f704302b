"""When measurements decide a claim, and what they say then.

A size counts only where every scene has it with enough runs; ranges over the runs that touch decide nothing.
"""

from dataclasses import dataclass

from report.claims.finding import NOT_DECIDED, NOT_MEASURED
from report.text import count_text

RUNS, RUNS_OF_LARGE, LARGE = 5, 3, 1e8  # hits from which on fewer runs are enough


def wanted_runs(hits):
    return RUNS_OF_LARGE if hits >= LARGE else RUNS


def has_enough_runs(row):
    return row["repetitions"] >= wanted_runs(row["hits_asked"])


@dataclass(frozen=True)
class Outcome:
    """One light map beside one photon map: of one scene and number of hits."""

    scene: str
    hits: int
    runs: int  # the fewer of the two
    sign: int  # -1: the light map's figure is clearly less, 1: clearly more, 0: the ranges touch


def judged(outcomes, scenes):
    """Signs by size, of those sizes that every scene has; and what is said of the others."""
    signs, lacking = {}, []
    for hits in sorted({o.hits for o in outcomes}):
        counted = {o.scene: o.sign for o in outcomes if o.hits == hits and o.runs >= wanted_runs(hits)}
        if len(counted) == len(scenes):
            signs[hits] = set(counted.values())
        else:
            lacking.append(f"{count_text(hits)}: {len(counted)} of {len(scenes)} scenes with {wanted_runs(hits)} runs")
    return signs, lacking


def verdict_by_hits(outcomes, scenes):
    """The verdict and its condition: confirmed or refuted where all sizes agree."""
    if not outcomes:
        return NOT_MEASURED, ""
    signs, lacking = judged(outcomes, scenes)
    verdict, condition = verdict_of(signs)
    left_out = f"not judged at {'; '.join(lacking)}" if lacking else ""
    return verdict, "; ".join(filter(None, (condition, left_out)))


def verdict_of(signs):
    if not signs:
        return NOT_DECIDED, ""
    wins = [hits for hits, s in signs.items() if s == {-1}]
    if len(wins) == len(signs):
        return "confirmed", ""
    if all(s == {1} for s in signs.values()):
        return "refuted", ""
    others = [hits for hits in signs if hits not in wins]
    if later := [hits for hits in wins if hits > max(others)]:
        return "conditional", f"true in every scene from {count_text(min(later))} hits on, not at {count_text(max(others))} and below"
    if wins or any(-1 in s for s in signs.values()):
        return "conditional", "true in some scenes or at some sizes only"
    losses = [hits for hits, s in signs.items() if s == {1}]
    return NOT_DECIDED, f"false in every scene at {', '.join(map(count_text, losses))}" if losses else ""


def sizes_in_all(rows_by_scene):
    """Rows of those sizes that every scene has with enough runs; and what is said of the others."""
    counted = {scene: {row["hits_asked"]: row for row in rows if has_enough_runs(row)} for scene, rows in rows_by_scene.items()}
    every = sorted({row["hits_asked"] for rows in rows_by_scene.values() for row in rows})
    common = [hits for hits in every if all(hits in rows for rows in counted.values())]
    lacking = [
        f"{count_text(hits)}: {sum(hits in rows for rows in counted.values())} of {len(counted)} scenes with {wanted_runs(hits)} runs"
        for hits in every
        if hits not in common
    ]
    kept = {scene: [rows[hits] for hits in common] for scene, rows in counted.items()}
    return kept, f"not judged at {'; '.join(lacking)}" if lacking else ""


def runs_of(rows):
    """Fewest and most; empty without rows."""
    runs = [row["repetitions"] for row in rows]
    return (min(runs), max(runs)) if runs else ()


def range_text(values, form="{:.2f}"):
    """1.10 to 1.25, or one number."""
    low, high = form.format(min(values)), form.format(max(values))
    return low if low == high else f"{low} to {high}"
