"""Compares irradiances by `shlmbench reference` with Mitsuba 3: see README.md, and `run` beside this file."""

import argparse
import json
import platform
import subprocess
import sys
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path

from variant import use_fastest_variant

use_fastest_variant()

# Only now: these bind the variant's types.
import mitsuba as mi  # noqa: E402

from agreement import LARGEST_Z, compare  # noqa: E402
from crosscheck_report import markdown, table  # noqa: E402
from glb_scene import read_scene  # noqa: E402
from input_error import InputError  # noqa: E402
from irradiance import estimate_irradiance  # noqa: E402
from mitsuba_scene import mitsuba_scene  # noqa: E402
from reference_file import check_points_lie_on, read_reference  # noqa: E402

BATCHES = 64
SEED = 1


def arguments():
    parser = argparse.ArgumentParser(prog="run", description=__doc__)
    parser.add_argument("files", nargs="+", metavar="SCENE.glb REFERENCE.exr", help="pairs of a scene and its reference")
    parser.add_argument("--spp", type=int, default=1024, help=f"Mitsuba's samples per point, a multiple of {BATCHES} (default 1024)")
    parser.add_argument("--out", type=Path, default=Path("results/crosscheck"), help="folder (default results/crosscheck)")
    given = parser.parse_args()
    if len(given.files) % 2 == 1:
        parser.error("every SCENE.glb needs its REFERENCE.exr")
    if given.spp < BATCHES or given.spp % BATCHES != 0:
        parser.error(f"--spp must be a multiple of {BATCHES}")
    return given


def paths_not_found(scene):
    """What neither path tracer can sample, so that their agreement says nothing about it."""
    is_specular = any(mesh.material.kind != "diffuse" for mesh in scene.meshes)
    if is_specular and (scene.point_lights or scene.spot_lights):
        return "light of point and spot lights by way of mirrors and glass"
    return "none"


def check(scene_file, reference_file, spp):
    name = Path(scene_file).stem
    scene = read_scene(scene_file)
    reference = read_reference(reference_file)
    traced = mitsuba_scene(scene)
    check_points_lie_on(traced, reference, reference_file)

    def report(batch):
        if sys.stderr.isatty():
            print(f"\r{name}: batch {batch} of {BATCHES}", end="\n" if batch == BATCHES else "", file=sys.stderr, flush=True)

    theirs = estimate_irradiance(traced, reference.points, BATCHES, spp // BATCHES, SEED, report)
    agreement = compare(reference.estimate, theirs, reference.region_of)
    return {
        "scene": name,
        **agreement.as_json(),
        "paths_not_found": paths_not_found(scene),
        "reference": reference.notes,
    }


def context(spp):
    described = subprocess.run(
        ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty", "--abbrev=12"],
        capture_output=True,
        text=True,
        check=False,
    )
    return {
        "date": datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "commit": described.stdout.strip() or "unknown",
        "mitsuba": mi.__version__,
        "drjit": version("drjit"),
        "numpy": version("numpy"),
        "python": platform.python_version(),
        "variant": mi.variant(),
        "integrator": "path, unlimited depth",
        "samples per point": spp,
        "batches": BATCHES,
        "seed": SEED,
        "largest |z| that agrees": LARGEST_Z,
    }


def write(file, text):
    temporary = file.with_name(f".{file.name}")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(file)


def make_folder(folder):
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"--out: {error}") from error


def main():
    given = arguments()
    make_folder(given.out)  # before the minutes of tracing
    pairs = zip(given.files[::2], given.files[1::2])
    rows = [check(scene, reference, given.spp) for scene, reference in pairs]
    document = {"context": context(given.spp), "rows": rows}
    write(given.out / "crosscheck.json", json.dumps(document, indent=2) + "\n")
    write(given.out / "crosscheck.md", markdown(document))
    print("\n".join(table(rows)))
    return 0 if all(row["verdict"] == "agree" for row in rows) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except InputError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
