"""What is kept of a measured scene: a JSON file, from which the report is made."""

import hashlib
import json
import statistics
from dataclasses import asdict
from pathlib import Path
from urllib.parse import unquote

from report.elsewhere.bounds import bounds_of, verdict_of
from report.elsewhere.figures import Error, figures
from report.elsewhere.images import write_strip
from report.elsewhere.scenes import document_of
from report.study.data import Study, StudyError
from report.study.methods import REFERENCE_LIGHT_MAP


def key_of(program, found, settings):
    """Equal for two runs that would measure the same: of the program, the scene's files, and all that is asked for."""
    digest = hashlib.sha256()
    for file in [Path(program), found.file, *files_named_in(found.file)]:
        digest.update(file.read_bytes() if file.is_file() else b"missing")
    digest.update(json.dumps([found.name, found.options, settings.as_json()]).encode())
    return digest.hexdigest()


def files_named_in(scene_file):
    document = document_of(scene_file)
    if not isinstance(document, dict):
        return []
    parts = [part for kind in ("buffers", "images") for part in document.get(kind, []) if isinstance(part, dict)]
    uris = [part["uri"] for part in parts if isinstance(part.get("uri"), str)]
    return [scene_file.parent / unquote(uri) for uri in uris if not uri.startswith("data:")]


def kept_record(file, key):
    """That of an earlier run; None where it is another one's, failed, or is not there."""
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return record if record.get("key") == key and "failed" not in record else None


def write_text(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    temporary = file.with_name(f".{file.name}")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(file)


def as_text(document):
    return json.dumps(nan_as_null(document), indent=1, allow_nan=False, ensure_ascii=False) + "\n"


def nan_as_null(value):
    if isinstance(value, dict):
        return {key: nan_as_null(v) for key, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [nan_as_null(v) for v in value]
    return None if isinstance(value, float) and value != value else value


def full_names(asked, measured):
    """{name as asked for: name as measured}. A name that is a part of several stands for the one that no longer name asks for."""
    left, found = list(measured), {}
    for name in sorted(asked, key=lambda n: -n.count("/")):
        match = next((m for m in left if m == name or m.startswith(f"{name}/")), None)
        if match is None and name == "shlm" and REFERENCE_LIGHT_MAP in measured:
            match = REFERENCE_LIGHT_MAP  # the default is one of those that were asked for by their full names
        if match is None:
            continue
        found[name] = match
        if match in left:
            left.remove(match)
    return {name: found[name] for name in asked if name in found}


def measured(study_folder, name, methods, image_file):
    """(rows of methods, bounds, context) of a finished study; writes the pictures."""
    study = Study(study_folder)
    if not study.scenes:
        raise StudyError("; ".join(study.problems) or "the study has no scene")
    scene_name, scene = next(iter(study.scenes.items()))
    entry = study.entry(scene_name)
    runs = {(run.method, run.hits_asked): (run, answers) for run, answers in study.runs(scene_name)}
    full = full_names(methods, study.methods)
    rows, found, means = [], {}, {}
    most = max((hits for _, hits in runs), default=0)
    for asked, method in full.items():
        if method in [row["method"] for row in rows]:
            continue  # asked for by two names
        for hits in sorted({h for m, h in runs if m == method}):
            run, answers = runs[method, hits]
            answers = answers.astype(float)
            result = figures(scene, answers, entry["width"])
            rows.append(row_of(asked, run, result))
            if hits == most:
                found[asked], means[asked] = result, answers.mean(axis=0)
    for method, hits, reason in study.skipped(scene_name):
        rows.append({"asked": method, "method": method, "hits": hits, "skipped": reason})
    write_strip(image_file, scene, (entry["width"], entry["height"]), means.get("shlm"), means.get("photonmap"))
    bounds = bounds_of(found)
    return {
        "points": scene.points,
        "methods": rows,
        "bounds": [asdict(bound) for bound in bounds],
        "verdict": verdict_of(bounds) if bounds else "not measured",
        "reference_error": scene.reference_error_sq**0.5,
        "context": study.context,
        "problems": study.problems,
    }


def row_of(asked, run, result):
    return {
        "asked": asked,
        "method": run.method,
        "hits": run.median("hits"),
        "seeds": list(run.seeds),
        "seconds": statistics.median(run.total_seconds().tolist()),
        "bytes": run.median("bytes"),
        **result.as_json(),
    }


def error_of(values):
    """Error from its JSON."""
    return None if values is None else Error(values["value"], float("nan") if values["chance"] is None else values["chance"])
