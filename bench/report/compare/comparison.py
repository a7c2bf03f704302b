"""What `shlmbench compare` has measured, read back."""

import json
from collections import defaultdict
from copy import copy
from pathlib import Path

PHOTON_MAP = "photonmap/flann/k50/disc"
INCREMENTAL = "photonmap/flann-incremental/k50/disc"
LIGHT_MAP = "shlm/L2/radiance/surface4"  # what "shlm" stands for
PAPER_LIGHT_MAP = "shlm/L2/radiance/knn4"  # asked as in the paper: the nearest texels, of whatever surface
LIGHT_MAP_FLUX = "shlm/L2/flux/surface4"
MAP_COLUMNS = ("making_room_seconds", "trace_and_insert_seconds", "build_seconds")


class Comparison:
    """The rows of one compare.json, by scene, method and number of hits asked for.

    `light_map` is the one that claims are judged of: the default where it was measured, else the paper's.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        with open(self.folder / "compare.json", encoding="utf-8") as file:
            document = json.load(file)
        self.context = document["context"]
        self.rows = document["rows"]
        self._measured = defaultdict(dict)
        for row in self.rows:
            if "skipped" not in row:
                self._measured[row["scene"], row["method"]][row["hits_asked"]] = row
        self.light_map = PAPER_LIGHT_MAP if PAPER_LIGHT_MAP in self.methods and LIGHT_MAP not in self.methods else LIGHT_MAP

    def judging(self, light_map):
        """The same rows for claims of another light map."""
        other = copy(self)
        other.light_map = light_map
        return other

    def facts(self, method):
        """The "fields" and "style" that the method's rows have."""
        row = next(row for row in self.rows if row["method"] == method)
        return row["fields"], row["style"]

    def engine(self, method):
        """Of a photon map; "" for other methods."""
        return self.facts(method)[0].get("engine", "")

    @property
    def scenes(self):
        return list(dict.fromkeys(row["scene"] for row in self.rows))

    @property
    def methods(self):
        return list(dict.fromkeys(row["method"] for row in self.rows))

    def series(self, scene, method):
        """Measured rows in ascending order of hits."""
        by_hits = self._measured[scene, method]
        return [by_hits[hits] for hits in sorted(by_hits)]

    def row(self, scene, method, hits):
        """The measured row; None without one."""
        return self._measured[scene, method].get(hits)


def map_seconds(row):
    """From nothing to a map that can be asked: the empty store, trace, insert, build."""
    return sum(row[column] for column in MAP_COLUMNS)
