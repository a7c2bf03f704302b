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


def table(rows):
    lines = [
        "| scene | points | ours W/m^2 | Mitsuba W/m^2 | difference % | standard error % | z | z of R, G, B | rms z of points | rms z of regions "
        "| largest z of a region | verdict |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        channels = ", ".join(f"{z:+.2f}" for z in row["channel_z"])
        lines.append(
            f"| {row['scene']} | {row['points']} | {row['ours']:.5g} | {row['theirs']:.5g} | {100 * row['difference']:+.3f} "
            f"| {100 * row['standard_error']:.3f} | {row['z']:+.2f} | {channels} | {row['rms_z']:.2f} | {row['region_rms_z']:.2f} "
            f"| {row['region_z']:+.2f} of {row['region_z_bound']:.2f} | **{row['verdict']}** |"
        )
    return lines


def reference_table(rows):
    notes = ["commit", "date", "seed", "samples_per_pixel", "relative_error", "fingerprint"]
    lines = [f"| reference | {' | '.join(notes)} |", "|---" * (len(notes) + 1) + "|"]
    for row in rows:
        values = [row["reference"].get(f"shlmbench:{note}", "") for note in notes]
        lines.append(f"| {row['scene']} | {' | '.join(values)} |")
    return lines


def markdown(document):
    rows = document["rows"]
    return "\n".join(
        [
            "# Our reference path tracer and Mitsuba 3",
            "",
            *table(rows),
            "",
            "Mean irradiance over the points that the camera sees. z is a difference over its standard error, from both renderers' variances.",
            f"A scene agrees if z, of all channels and of each, is within {LARGEST_Z:g}, and no region of 8 x 8 pixels passes its bound, which one",
            "in 370 right scenes does by accident. What is compared, and how: bench/crosscheck/README.md.",
            "",
            "## Paths that neither finds",
            "",
            *[f"- {row['scene']}: {row['paths_not_found']}" for row in rows],
            "",
            "## How this was made",
            "",
            *[f"- {key}: {value}" for key, value in document["context"].items()],
            "",
            *reference_table(rows),
            "",
        ]
    )


def write(file, text):
    temporary = file.with_name(f".{file.name}")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(file)


def main():
    given = arguments()
    pairs = zip(given.files[::2], given.files[1::2])
    rows = [check(scene, reference, given.spp) for scene, reference in pairs]
    document = {"context": context(given.spp), "rows": rows}
    given.out.mkdir(parents=True, exist_ok=True)
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
