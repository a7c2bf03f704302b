"""Measures the scenes of a folder, made by others, and writes OUT/report.md, OUT/elsewhere.json and OUT/images:

    bench/report elsewhere PROGRAM FOLDER OUT --methods shlm,photonmap,... [--hits 1e6,1e7] [--seeds 2] ...

PROGRAM is shlmbench. Stopped, it goes on from the last finished scene; what another build has measured is measured again. A scene that
cannot be measured is a row that says why. Exit code: 0; 1 if a scene could not be measured or misses a bound; 2 for bad input;
130 if stopped.
"""

import argparse
import json
import shutil
import sys
import time
from datetime import datetime, timezone
from pathlib import Path

from report.elsewhere.bounds import MISSED
from report.elsewhere.record import as_text, kept_record, key_of, measured, write_text
from report.elsewhere.run import SceneFailed, SceneRun, Settings
from report.elsewhere.scenes import find_scenes
from report.elsewhere.text import markdown, summary_cells
from report.study.data import StudyError


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="bench/report elsewhere", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="PROGRAM")
    parser.add_argument("folder", metavar="FOLDER", type=Path)
    parser.add_argument("out", metavar="OUT", type=Path)
    parser.add_argument("--methods", required=True)
    parser.add_argument("--hits", default="1e6,1e7")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--reference-until", default="0.5%")
    parser.add_argument("--reference-seconds", type=float, default=300)
    parser.add_argument("--fit-seconds", type=float, default=600)
    parser.add_argument("--fit-max-hits", default="1e8")
    return parser.parse_args(arguments)


def settings_of(given):
    return Settings(
        given.methods,
        given.hits,
        given.seeds,
        given.reference_until,
        given.reference_seconds,
        given.fit_seconds,
        given.fit_max_hits,
    )


def measure(scene_run, image_file):
    """A scene's record but for its name and key. Raises SceneFailed or StudyError."""
    info = scene_run.info()
    begin = time.monotonic()
    reference = scene_run.reference()
    reference["seconds"] = time.monotonic() - begin
    scene_run.study()
    methods = scene_run.settings.methods.split(",")
    record = measured(scene_run.study_folder, scene_run.found.name, methods, image_file)
    return {"info": info, "reference": reference, **record, "fit": shortened(scene_run.fit())}


def shortened(fit):
    """The choices, without all the candidates behind them."""
    return {key: value for key, value in fit.items() if key in ("reason", "target", "light_map", "photon_map", "pilot", "max_hits", "seed")}


def record_of(program, found, out, settings):
    record_file = out / "scenes" / f"{found.name}.json"
    key = key_of(program, found, settings)
    record = kept_record(record_file, key)
    if record is not None:
        return record
    work = out / "work" / found.name
    if not same_key(work / "key", key):
        shutil.rmtree(work, ignore_errors=True)  # of another build, or of other settings
        write_text(work / "key", key)
    about = {"name": found.name, "key": key, "file": found.file.name, "options": list(found.options), "credit": found.credit}
    try:
        record = {**about, **measure(SceneRun(program, found, work, settings), out / "images" / f"{found.name}.png")}
        shutil.rmtree(work)  # megabytes of answers that the record sums up
    except (SceneFailed, StudyError) as error:
        record = {**about, "failed": " ".join(str(error).split())}
    write_text(record_file, as_text(record))
    return json.loads(as_text(record))


def same_key(file, key):
    try:
        return file.read_text(encoding="utf-8") == key
    except OSError:
        return False


def write_report(out, records, dark, settings):
    document = {
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "settings": settings.as_json(),
        "without_light": [file.name for file in dark],
        "scenes": records,
    }
    write_text(out / "elsewhere.json", as_text(document))
    write_text(out / "report.md", markdown(document))


def main(arguments):
    given = parsed(arguments)
    settings = settings_of(given)
    try:
        scenes, dark = find_scenes(given.folder)
        (given.out / "scenes").mkdir(parents=True, exist_ok=True)
    except (StudyError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    records = []
    for number, found in enumerate(scenes, 1):
        print(f"{found.name}, {number} of {len(scenes)}", file=sys.stderr)
        records.append(record_of(given.program, found, given.out, settings))
        write_report(given.out, records, dark, settings)
        print(" | ".join(summary_cells(records[-1])), flush=True)
    shutil.rmtree(given.out / "work", ignore_errors=True)
    print(f"\n{given.out / 'report.md'}")
    return 1 if any("failed" in r or r["verdict"] == MISSED for r in records) else 0
