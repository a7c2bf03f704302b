"""Compares irradiances by `shlmbench reference` with Mitsuba 3: see README.md, and `run` beside this file."""

import argparse
import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from input_error import InputError
from scene import DirectionalLight
from variant import VARIANTS, use_variant

# As check_scene.py has it, which can only be imported once there is a variant.
BATCHES = 64


def numbers(count):
    def parse(text):
        values = [float(part) for part in text.split(",")]
        if len(values) != count or not np.isfinite(values).all():
            raise ValueError(text)
        return values

    return parse


def arguments():
    parser = argparse.ArgumentParser(prog="run", description=__doc__)
    parser.add_argument("files", nargs="+", metavar="SCENE REFERENCE.exr", help="pairs of a scene, .gltf or .glb, and its reference")
    parser.add_argument("--spp", type=int, default=1024, help=f"Mitsuba's samples per point, a multiple of {BATCHES} (default 1024)")
    parser.add_argument("--out", type=Path, default=Path("results/crosscheck"), help="folder (default results/crosscheck)")
    parser.add_argument("--sky", type=numbers(3), metavar="R,G,B", help="as the references were made with")
    parser.add_argument("--sun", type=numbers(6), metavar="X,Y,Z,R,G,B", help="as the references were made with")
    parser.add_argument("--variant", choices=VARIANTS, help="of Mitsuba (default: the fastest that runs here)")
    parser.add_argument("--threads", type=int, help="of llvm_ad_rgb (default: all)")
    parser.add_argument("--rr-depth", type=int, metavar="BOUNCES", help="before chance may end a path (default: by each scene's albedo)")
    given = parser.parse_args()
    if len(given.files) % 2 == 1:
        parser.error("every SCENE needs its REFERENCE.exr")
    if given.spp < BATCHES or given.spp % BATCHES != 0:
        parser.error(f"--spp must be a multiple of {BATCHES}")
    if given.threads is not None and given.threads < 1:
        parser.error("--threads must be at least 1")
    if given.rr_depth is not None and given.rr_depth < 1:
        parser.error("--rr-depth must be at least 1")
    if given.sun is not None and not any(given.sun[:3]):
        parser.error("--sun: X,Y,Z is the direction to the sun and cannot be 0,0,0")
    return given


def more_light(given):
    """A function from a scene to one that has --sky and --sun as well."""
    suns = []
    if given.sun:
        towards = np.array(given.sun[:3])
        suns.append(DirectionalLight(tuple(-towards / np.linalg.norm(towards)), tuple(given.sun[3:])))

    def with_light(scene):
        sky = scene.sky_radiance if given.sky is None else tuple(given.sky)
        return replace(scene, sky_radiance=sky, directional_lights=[*scene.directional_lights, *suns])

    return with_light


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
    use_variant(given.variant)

    # Only now: these bind the variant's types.
    import drjit

    from check_scene import check, context
    from crosscheck_report import markdown, table

    if given.threads:
        drjit.set_thread_count(given.threads)
    pairs = zip(given.files[::2], given.files[1::2])
    rows = [check(scene, reference, given.spp, more_light(given), given.rr_depth) for scene, reference in pairs]
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
