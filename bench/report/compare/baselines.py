"""Which photon map a claim is judged against: insertion into FLANN's tree, as the paper words it, and the strongest engine.

The strongest is found by measurement, not by name: of the exact photon maps with a row of the same scene and number of hits,
the one whose figure is least, the figure being the claim's own. A photon map is exact if its search finds the true neighbours:
all are but flann-incremental. Where the figure is the time of a gather, those compete whose error is no greater than that of
k50/disc, the photon map of the paper, by a study of the same scenes: a grid too, which takes all photons within a radius.
Without such a study only k50/disc itself competes.
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


# --- which gathers are as accurate as the reference's


def question_of(method):
    """What a photon map answers, whatever its engine: "k50/disc". Names are FAMILY/ENGINE/SELECTION/KERNEL."""
    return method.split("/", 2)[2]


def errors_by_question(study, scene, hits):
    """Points of the study's photon maps at that size, by what they answer."""
    methods = study["scenes"].get(scene, {}).get("methods", {}) if study else {}
    found = {}
    for method, points in methods.items():
        if method.startswith("photonmap/"):
            found |= {question_of(method): point for point in points if point["hits_asked"] == hits}
    return found


def is_as_accurate(comparison, study):
    """(method, scene, hits) -> whether its error is at most that of k50/disc, as far as the study's bands tell."""

    def admits(method, scene, hits):
        if answers_as_the_reference(comparison, method):
            return True
        errors = errors_by_question(study, scene, hits)
        mine, reference = errors.get(question_of(method)), errors.get("k50/disc")
        return bool(mine and reference and mine["error"] <= reference["error_band"][1])

    return admits


@dataclass(frozen=True)
class Figure:
    """What of a row is compared."""

    value: Callable  # row -> number
    bounds: Callable  # row -> (smallest, largest) over the repetitions


def column_bounds(row, name):
    return row.get(name + "_range", (row[name], row[name]))


def sum_of(names):
    """Of columns, each with its range."""

    def bounds(row):
        ranges = [column_bounds(row, name) for name in names]
        return sum(low for low, _ in ranges), sum(high for _, high in ranges)

    return Figure(lambda row: sum(row[name] for name in names), bounds)


def nanoseconds_a_hit(row):
    """Of one second of wall time of all threads."""
    return 1e9 * row.get("threads", 1) / row["hits"]


def insertion(row, ratio):
    """ns a hit and thread: what the run takes longer than the same run without a store, by their paired ratio."""
    return (ratio - 1) * row["trace_seconds"] * nanoseconds_a_hit(row)


def insertion_bounds(row):
    return tuple(insertion(row, ratio) for ratio in column_bounds(row, "ratio_to_null_sink"))


def insertion_with_build_bounds(row):
    builds = column_bounds(row, "build_seconds")
    return tuple(bound + build * nanoseconds_a_hit(row) for bound, build in zip(insertion_bounds(row), builds))


MAP_SECONDS = sum_of(MAP_COLUMNS)
FIRST_MAP_SECONDS = sum_of(("prepare_seconds", *MAP_COLUMNS))  # the scene's preparation included
GATHER_US = sum_of(("gather_us_per_query",))
BYTES = sum_of(("bytes",))
INSERT_NS = Figure(lambda row: insertion(row, row["ratio_to_null_sink"]), insertion_bounds)
# What a hit costs until it can be found: its insertion, and its share of a build that comes after.
INSERT_AND_BUILD_NS = Figure(
    lambda row: INSERT_NS.value(row) + row["build_seconds"] * nanoseconds_a_hit(row), insertion_with_build_bounds
)


@dataclass(frozen=True)
class Baseline:
    """Gives the row of a scene and number of hits that the light map is held against; None without one."""

    name: str
    plain_name: str  # for who does not know the engines
    row: Callable  # (scene, hits_asked) -> row or None

    def pairs(self, comparison):
        """(scene, the light map's row, the baseline's) wherever both are measured."""
        return [(scene, mine, theirs) for scene in comparison.scenes for mine in comparison.series(scene, comparison.light_map)
                if (theirs := self.row(scene, mine["hits_asked"]))]

    def series(self, comparison, scene):
        sizes = sorted({row["hits_asked"] for row in comparison.rows if row["scene"] == scene})
        return [row for hits in sizes if (row := self.row(scene, hits))]


def incremental(comparison):
    return Baseline("flann-incremental", "a tree that takes photons one by one", lambda scene, hits: comparison.row(scene, INCREMENTAL, hits))


def strongest(comparison, figure, admits=lambda method, scene, hits: True):
    """The exact photon map whose `figure` is least at that size, among those that `admits` lets compete there."""
    methods = [method for method in comparison.methods if is_exact(comparison, method)]

    def row(scene, hits):
        rows = [row for method in methods if admits(method, scene, hits) and (row := comparison.row(scene, method, hits))]
        return min(rows, key=figure.value, default=None)

    return Baseline("the strongest engine", "today's strongest photon map", row)


def sign_of(mine, theirs, figure):
    """-1: mine is clearly less, 1: clearly more, 0: the ranges touch."""
    my_low, my_high = figure.bounds(mine)
    their_low, their_high = figure.bounds(theirs)
    return -1 if my_high < their_low else 1 if my_low > their_high else 0
