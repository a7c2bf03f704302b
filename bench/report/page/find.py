"""Which results the given folders hold: each folder itself, and the folders in it, one level deep."""

import json
import os
from dataclasses import dataclass, field
from pathlib import Path

from report.study.data import StudyError


def read_json(file):
    """Raises StudyError, one line, where the file is no JSON."""
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise StudyError(f"{file} cannot be read: {error}") from error


@dataclass(frozen=True)
class Source:
    """One file of results, read."""

    file: Path
    document: object

    @property
    def folder(self):
        return self.file.parent

    @property
    def name(self):
        return self.folder.resolve().name

    @property
    def context(self):
        return self.document["context"]


@dataclass
class Results:
    """Every part may be missing. `out`: the page that links to them."""

    out: Path
    folders: list = field(default_factory=list)
    verdicts: list = field(default_factory=list)
    studies: list = field(default_factory=list)
    comparisons: list = field(default_factory=list)
    limits: list = field(default_factory=list)
    stability: list = field(default_factory=list)
    bases: list = field(default_factory=list)
    fits: list = field(default_factory=list)
    promises: list = field(default_factory=list)
    histories: list = field(default_factory=list)
    elsewhere: list = field(default_factory=list)
    realtime: list = field(default_factory=list)

    def link(self, path):
        """From the page."""
        return Path(os.path.relpath(path, self.out.parent)).as_posix()

    @property
    def study(self):
        """The one that charts are drawn of: the one with the most rows. Studies are not joined."""
        return max(self.studies, key=lambda s: rows_in(s.document), default=None)

    def context_of(self, folder_name):
        """Of the comparison, study or measured pages whose folder has this name; None without one."""
        for source in (*self.comparisons, *self.studies, *self.realtime):
            if source.name == folder_name:
                return source.context
        return None

    @property
    def is_empty(self):
        parts = (self.verdicts, self.studies, self.comparisons, self.stability, self.bases, self.fits, self.promises, self.histories, self.elsewhere, self.realtime)
        return not any(parts)


def rows_in(summary):
    return sum(len(points) for scene in summary["scenes"].values() for points in scene["methods"].values())


PLACES = {  # part -> files of one folder
    "verdicts": "verdicts.json",
    "studies": "summary.json",
    "comparisons": "compare.json",
    "limits": "limit-*.json",
    "stability": "stability.json",
    "bases": "bases.json",
    "fits": "fit/*/*/fit.json",
    "promises": "promise/promise.json",
    "elsewhere": "elsewhere.json",
    "realtime": "realtime.json",
}
NEEDED = {"studies": "scenes", "comparisons": "rows", "stability": "rows", "realtime": "rows"}  # what a part cannot do without


OWN_RUNS = "latest"  # what ./reproduce leaves beside the kept results; it has a page of its own


def folders_of(given):
    """Each folder, then those in it, in order and once."""
    found = []
    for folder in map(Path, given):
        if not folder.is_dir():
            raise StudyError(f"{folder} is no folder")
        children = sorted(child for child in folder.iterdir() if child.is_dir() and child.name != OWN_RUNS)
        found += [f for f in (folder, *children) if f.resolve() not in {known.resolve() for known in found}]
    return found


def find(out, given):
    """Raises StudyError where a folder is missing or a file cannot be read."""
    results = Results(Path(out), folders_of(given))
    for folder in results.folders:
        for part, pattern in PLACES.items():
            for file in sorted(folder.glob(pattern)):
                document = read_json(file)
                if part in NEEDED and (not isinstance(document, dict) or NEEDED[part] not in document or "context" not in document):
                    raise StudyError(f"{file} is not what its name says: it has no {NEEDED[part]}")
                getattr(results, part).append(Source(file, document))
        for file in sorted(folder.glob("*.jsonl")):
            results.histories.append(Source(file, history_lines(file)))
    return results


def history_lines(file):
    try:
        return [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines() if line.strip()]
    except (OSError, ValueError) as error:
        raise StudyError(f"{file} cannot be read: {error}") from error
