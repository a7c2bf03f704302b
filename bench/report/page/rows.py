"""The measured rows of a study, as the page draws them: one method at one number of hits in one scene.

Errors in summary.json are means of squares relative to the reference; here they are relative RMS in per cent. What is
at or below zero (a bias lost in the noise) is 0, what was not measured is None.
"""

import math
import re
from dataclasses import dataclass

from report.page.find import read_json
from report.study.methods import Method, method_of
from report.text import is_number


def percent(square):
    return None if not is_number(square) else 100 * math.sqrt(max(square, 0.0))


def percent_band(band):
    return [percent(end) for end in band] if band else None


@dataclass(frozen=True)
class Row:
    number: int  # its place in the list, and its id in the page
    scene: str
    method: str
    hits_asked: int
    hits: float
    seeds: int
    error: float
    error_band: list
    bias: float
    bias_band: list
    noise: float
    noise_band: list
    flip: float  # mean HDR-FLIP of the first seed's picture
    seconds: float  # trace, insert, build, gather
    bytes: float  # of the finished map
    working: float  # bytes while it is filled
    prepare_seconds: float


def row_of(number, scene, method, point):
    return Row(
        number,
        scene,
        method,
        point["hits_asked"],
        point["hits"],
        point["seeds"],
        percent(point["error"]),
        percent_band(point["error_band"]),
        percent(point["bias_sq"]),
        percent_band(point["bias_sq_band"]),
        percent(point["variance"]),
        percent_band(point["variance_band"]),
        point.get("flip_of_first_seed"),
        point["total_seconds"],
        point["bytes"],
        point.get("insert_bytes"),
        point.get("prepare_seconds"),
    )


@dataclass(frozen=True)
class Kind:
    """A method of the study: what its rows say that it is."""

    method: Method
    fields: dict
    texels: int  # of its map; 0 for a method without texels


class StudyRows:
    def __init__(self, source):
        """`source`: of a summary.json, whose study.json says what the methods are."""
        self.source = source
        summary = source.document
        self.context = summary["context"]
        self.scenes = list(summary["scenes"])
        self.rows = []
        for scene, entry in summary["scenes"].items():
            for method, points in entry["methods"].items():
                self.rows += [row_of(len(self.rows) + i, scene, method, p) for i, p in enumerate(points)]
        self.kinds = kinds_of(source, list(dict.fromkeys(row.method for row in self.rows)))

    def family(self, name):
        """As the program names it: shlm, photonmap, ..."""
        return self.kinds[name].fields.get("family", name.split("/")[0])

    @property
    def families(self):
        return list(dict.fromkeys(self.family(row.method) for row in self.rows))

    @property
    def best_known(self):
        """The best of each kind, as the study's report chooses them: what is bright at first."""
        return [name for name in self.source.document.get("groups", {}).get("methods", []) if name in self.kinds]

    @property
    def setting_texels(self):
        """The number of texels of light maps that do not name theirs."""
        found = re.search(r"texels=(\d+)", str(self.context.get("settings", "")))
        return int(found.group(1)) if found else 0

    def reference_error(self, scene):
        return percent(self.source.document["scenes"][scene]["reference_error_sq"])


def kinds_of(source, names):
    file = source.folder / "study.json"
    first = {}
    if file.exists():
        for row in read_json(file)["rows"]:
            first.setdefault(row["method"], row)
    kinds = {}
    for name in names:
        row = first.get(name, {"method": name})
        fields = row.get("fields", {})
        kinds[name] = Kind(method_of(row), fields, (fields.get("texels") or row.get("texels") or 0) if "basis" in fields else 0)
    return kinds
