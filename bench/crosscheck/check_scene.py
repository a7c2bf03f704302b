"""One scene by both renderers. A variant must be set before this module is imported."""

import platform
import subprocess
import sys
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path

import mitsuba as mi

from agreement import LARGEST_Z, compare
from gltf_scene import read_scene
from irradiance import Method, estimate_irradiance
from mitsuba_scene import lets_light_through, mitsuba_scene
from reference_file import check_points_lie_on, read_reference
from roulette import roulette_depth

BATCHES = 64
SEED = 1


def paths_not_found(scene):
    """What neither path tracer can sample, so that their agreement says nothing about it."""
    ways = {
        "mirror": "by way of mirrors",
        "glass": "by way of glass",
        "sheet": "reflected by thin sheets",
    }
    kinds = {mesh.material.kind for mesh in scene.meshes}
    found = [way for kind, way in ways.items() if kind in kinds]
    if found and scene.lights_without_area:
        return f"light of point, spot and directional lights {' and '.join(found)}"
    return "none"


def check(scene_file, reference_file, spp, more_light, roulette):
    """A row of crosscheck.json. `more_light(scene)` adds what the command line says; `roulette`: bounces, or None."""
    name = Path(scene_file).stem
    scene = more_light(read_scene(scene_file))
    reference = read_reference(reference_file)
    traced = mitsuba_scene(scene)
    check_points_lie_on(traced, reference, reference_file)
    method = Method(lets_light_through(scene), roulette_depth(scene) if roulette is None else roulette)

    def report(batch):
        if sys.stderr.isatty():
            print(f"\r{name}: batch {batch} of {BATCHES}", end="\n" if batch == BATCHES else "", file=sys.stderr, flush=True)

    theirs = estimate_irradiance(traced, reference.points, BATCHES, spp // BATCHES, SEED, method, report)
    agreement = compare(reference.estimate, theirs, reference.region_of)
    return {
        "scene": name,
        **agreement.as_json(),
        "paths_not_found": paths_not_found(scene),
        "left_out": scene.left_out,
        "integrator": method.integrator,
        "roulette_after_bounces": method.roulette_depth,
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
        "samples per point": spp,
        "batches": BATCHES,
        "seed": SEED,
        "largest |z| that agrees": LARGEST_Z,
    }
