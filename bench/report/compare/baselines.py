"""Which photon map a claim is judged against: insertion into FLANN's tree, as the paper words it, and the strongest engine.

The strongest is found by measurement, not by name: of the exact photon maps with a row of the same scene and number of hits,
the one whose figure is least, the figure being the claim's own. A photon map is exact if its search finds the true neighbours:
all are but flann-incremental. Where the figure is the time of a gather, only methods that answer the same question are
compared (k50/disc): a grid, which takes all photons within a radius, is left out there.
"""

from dataclasses import dataclass
from typing import Callable

from report.compare.comparison import INCREMENTAL, MAP_COLUMNS


def engine_of(row):
    """The engine of a photon map's row; "" for other methods."""
    return row["fields"].get("engine", "")


def is_exact(comparison, method):
    return comparison.engine(method) not in ("", "flann-incremental")


def answers_as_the_reference(comparison, method):
    fields, _ = comparison.facts(method)
    return (fields.get("nearest"), fields.get("kernel")) == (50, "disc")


def one_per_engine(comparison):
    """The photon maps that stand for their engines: k50/disc where it was measured, else the first of the table."""
    chosen = {}
    for method in comparison.methods:
        if engine := comparison.engine(method):
            if engine not in chosen or (
                answers_as_the_reference(comparison, method) and not answers_as_the_reference(comparison, chosen[engine])
            ):
                chosen[engine] = method
    return list(chosen.values())


@dataclass(frozen=True)
class Figure:
    """A sum of a row's columns, each times a factor."""

    terms: Callable  # row -> {column: factor}

    def value(self, row):
        return sum(row[column] * factor for column, factor in self.terms(row).items())

    def bounds(self, row):
        """The smallest and largest sum over the repetitions, from the columns' ranges; the value itself without one."""
        low, high = 0.0, 0.0
        for column, factor in self.terms(row).items():
            least, most = row.get(column + "_range", (row[column], row[column]))
            low, high = low + least * factor, high + most * factor
        return low, high


def column(name):
    return Figure(lambda row: {name: 1.0})


MAP_SECONDS = Figure(lambda row: dict.fromkeys(MAP_COLUMNS, 1.0))
INSERT_NS = column("insert_ns_per_hit")
GATHER_US = column("gather_us_per_query")
BYTES = column("bytes")
# What a hit costs until it can be found: its insertion, and its share of a build that comes after.
INSERT_AND_BUILD_NS = Figure(lambda row: {"insert_ns_per_hit": 1.0, "build_seconds": 1e9 * row.get("threads", 1) / row["hits"]})


@dataclass(frozen=True)
class Baseline:
    """Gives the row of a scene and number of hits that the light map is held against; None without one."""

    name: str
    row: Callable  # (scene, hits_asked) -> row or None

    def pairs(self, comparison):
        """(scene, the light map's row, the baseline's) wherever both are measured."""
        return [(scene, mine, theirs) for scene in comparison.scenes for mine in comparison.series(scene, comparison.light_map)
                if (theirs := self.row(scene, mine["hits_asked"]))]

    def series(self, comparison, scene):
        sizes = sorted({row["hits_asked"] for row in comparison.rows if row["scene"] == scene})
        return [row for hits in sizes if (row := self.row(scene, hits))]


def incremental(comparison):
    return Baseline("flann-incremental", lambda scene, hits: comparison.row(scene, INCREMENTAL, hits))


def strongest(comparison, figure, counts=is_exact):
    """The exact photon map whose `figure` is least at that size, among the methods that `counts` admits."""
    methods = [method for method in comparison.methods if is_exact(comparison, method) and counts(comparison, method)]

    def row(scene, hits):
        rows = [row for method in methods if (row := comparison.row(scene, method, hits))]
        return min(rows, key=figure.value, default=None)

    return Baseline("the strongest engine", row)


def outcome(mine, theirs, figure):
    """-1: mine is clearly less, 1: clearly more, 0: the ranges touch."""
    my_low, my_high = figure.bounds(mine)
    their_low, their_high = figure.bounds(theirs)
    return -1 if my_high < their_low else 1 if my_low > their_high else 0
