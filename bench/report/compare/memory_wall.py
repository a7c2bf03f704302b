"""Where a method's memory ends: peaks measured, and drawn on in a straight line beyond what was measured.

The peak is what a method adds to the process at its fullest: the store, what building its index takes, the hits on their way.
"""

from dataclasses import dataclass

ENOUGH_HITS = 1e6  # below it, a photon map's bytes do not stand out from the process's own


@dataclass(frozen=True)
class Growth:
    """peak bytes = fixed + per_hit * hits"""

    rows: list  # measured, ascending
    fixed: float
    per_hit: float

    def bytes_at(self, hits):
        return self.fixed + self.per_hit * hits

    def hits_at(self, size):
        """How many hits fit into `size` bytes; None where their number does not matter."""
        return (size - self.fixed) / self.per_hit if self.per_hit > 0 else None


def peaks(comparison, scene, method):
    return [row for row in comparison.series(scene, method) if "peak_growth_bytes" in row]


def growth(comparison, scene, method):
    """None where no peak was measured, or at too few hits."""
    rows = peaks(comparison, scene, method)
    if not rows:
        return None
    last = rows[-1]
    if comparison.facts(method)[0]["family"] == "shlm":
        return Growth(rows, max(row["peak_growth_bytes"] for row in rows), 0.0)
    if last["hits"] < ENOUGH_HITS:
        return None
    before = [row for row in rows if row["hits"] < last["hits"] / 2]
    if not before:
        return Growth(rows, 0.0, last["peak_growth_bytes"] / last["hits"])
    per_hit = (last["peak_growth_bytes"] - before[-1]["peak_growth_bytes"]) / (last["hits"] - before[-1]["hits"])
    return Growth(rows, last["peak_growth_bytes"] - per_hit * last["hits"], per_hit)


def wall_bytes(comparison, scene):
    """--max-memory; the largest where runs differed. None for tables that do not have it."""
    return max((row["max_memory_bytes"] for row in comparison.rows if row["scene"] == scene and "max_memory_bytes" in row), default=None)


TEXEL_BYTES_FACTOR, BYTES_BESIDE = 1.1, 64 * 2**20


def peak_bound(row):
    """What a light map's run may add to the process: its texels while they are filled, a tenth more, and 64 MiB."""
    return TEXEL_BYTES_FACTOR * row["insert_bytes"] + BYTES_BESIDE


def light_map_peaks(comparison, scene):
    return peaks(comparison, scene, comparison.light_map)
