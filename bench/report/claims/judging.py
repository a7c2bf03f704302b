"""When measurements decide a claim, and what they say then.

A size counts only where every scene has it with enough runs; ranges over the runs that touch decide nothing.
"""

from dataclasses import dataclass, replace

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


def lacking_words(hits, count, scenes):
    return f"{count_text(hits)}: {count} of {scenes} scenes with {wanted_runs(hits)} runs"


def judged(outcomes, scenes):
    """Signs by size, of those sizes that every scene has; and what is said of the others."""
    signs, lacking = {}, []
    for hits in sorted({o.hits for o in outcomes}):
        counted = {o.scene: o.sign for o in outcomes if o.hits == hits and o.runs >= wanted_runs(hits)}
        if len(counted) == len(scenes):
            signs[hits] = set(counted.values())
        else:
            lacking.append(lacking_words(hits, len(counted), len(scenes)))
    return signs, lacking


@dataclass(frozen=True)
class Judgement:
    """What all sizes and scenes together say."""

    verdict: str
    from_hits: int = 0  # true in every scene from here on; 0: there is no such size, or it is true at all
    up_to_hits: int = 0  # the largest size where it is not
    fails_at: tuple = ()  # sizes, where nothing else is decided
    lacking: tuple = ()  # sizes that too few scenes or runs have, in words

    @property
    def condition(self):
        """All of it."""
        said = {
            "from": f"true in every scene from {count_text(self.from_hits)} hits on, not at {count_text(self.up_to_hits)} and below" if self.from_hits else "",
            "some": "true in some scenes or at some sizes only" if self.verdict == "conditional" and not self.from_hits else "",
            "fails": f"false in every scene at {', '.join(map(count_text, self.fails_at))}" if self.fails_at else "",
            "lacking": lacking_text(self.lacking),
        }
        return "; ".join(filter(None, said.values()))

    @property
    def plain(self):
        """In a few words, without what is lacking."""
        if self.verdict == "conditional":
            return f"holds from {count_text(self.from_hits)} hits on" if self.from_hits else "holds in some scenes or at some sizes only"
        if self.verdict == NOT_DECIDED and self.fails_at:
            return f"fails at {' and '.join(map(count_text, self.fails_at))} hits, else not decided"
        return {"confirmed": "holds at every size judged", "refuted": "fails at every size judged"}.get(self.verdict, self.verdict)


def lacking_text(lacking):
    return f"not judged at {'; '.join(lacking)}" if lacking else ""


def verdict_by_hits(outcomes, scenes):
    """Confirmed or refuted where all sizes agree."""
    if not outcomes:
        return Judgement(NOT_MEASURED)
    signs, lacking = judged(outcomes, scenes)
    return replace(verdict_of(signs), lacking=tuple(lacking))


def verdict_of(signs):
    """`signs`: hits -> the signs of all scenes."""
    if not signs:
        return Judgement(NOT_DECIDED)
    wins = [hits for hits, s in signs.items() if s == {-1}]
    if len(wins) == len(signs):
        return Judgement("confirmed")
    if all(s == {1} for s in signs.values()):
        return Judgement("refuted")
    others = [hits for hits in signs if hits not in wins]
    if later := [hits for hits in wins if hits > max(others)]:
        return Judgement("conditional", from_hits=min(later), up_to_hits=max(others))
    if wins or any(-1 in s for s in signs.values()):
        return Judgement("conditional")
    return Judgement(NOT_DECIDED, fails_at=tuple(hits for hits, s in signs.items() if s == {1}))


def sizes_in_all(rows_by_scene):
    """Rows of those sizes that every scene has with enough runs; and what is said of the others."""
    counted = {scene: {row["hits_asked"]: row for row in rows if has_enough_runs(row)} for scene, rows in rows_by_scene.items()}
    every = sorted({row["hits_asked"] for rows in rows_by_scene.values() for row in rows})
    common = [hits for hits in every if all(hits in rows for rows in counted.values())]
    lacking = [
        lacking_words(hits, sum(hits in rows for rows in counted.values()), len(counted))
        for hits in every
        if hits not in common
    ]
    kept = {scene: [rows[hits] for hits in common] for scene, rows in counted.items()}
    return kept, tuple(lacking)


def why_not_decided(lacking):
    """In plain words."""
    if lacking:
        return f"Too few runs at {' and '.join(words.split(':')[0] for words in lacking)} hits."
    return "What sizes differ by may be noise: their ranges over the runs touch."


def runs_of(rows):
    """Fewest and most; empty without rows."""
    runs = [row["repetitions"] for row in rows]
    return (min(runs), max(runs)) if runs else ()


def range_text(values, form="{:.2f}"):
    """1.10 to 1.25, or one number."""
    low, high = form.format(min(values)), form.format(max(values))
    return low if low == high else f"{low} to {high}"
