#!/usr/bin/python3
"""Pretends to be shlmbench for elsewhere_test.py: fake_shlmbench.py info|reference|study|fit SCENE ...

The scene's `extras` say what to pretend: `fails` with a line, a relative `error` of all answers, a `warning`, commands that are `slow`
and stop when asked to, an option that every command `needs`. Beside the scene it keeps a list of what it was asked to do.
"""

import json
import os
import signal
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from synthetic_study import write_array, write_json
from known_methods import facts_of

WIDTH, HEIGHT = 96, 54
STOPPED = 130


def option(name):
    return sys.argv[sys.argv.index(name) + 1]


def full_name(method):
    names = {"shlm": "shlm/L2/radiance/surface4", "photonmap": "photonmap/flann/k50/disc", "photonmap/compact": "photonmap/compact/k50/disc"}
    return names.get(method, method)


def info(extras):
    print(json.dumps({"scene": "pretended", "triangles": 12, "warnings": [extras["warning"]] if "warning" in extras else [],
                      "texels": {"instances_by_uv": 2, "instances_by_face": 1}}))


def reference(extras):
    def said(samples):
        return f"{out}: {samples} samples per pixel, relative error 0.4 %"

    def stop(*_):
        out.write_bytes(b"half")
        print(f"shlmbench: reference stopped: {said(64)}", file=sys.stderr)
        sys.exit(STOPPED)

    out = Path(option("--out"))
    wait_if_slow("reference", extras, stop)
    out.write_bytes(b"whole")
    print(said(640))


def study(extras):
    import numpy as np

    out, generator = Path(option("--out")), np.random.default_rng(1)
    if not (Path(option("--references")) / (Path(sys.argv[2]).stem + ".exr")).exists():
        sys.exit("shlmbench: --references: there is none")
    pixel = np.arange(WIDTH * HEIGHT)
    truth = (1 + pixel[:, None] % WIDTH / WIDTH) * np.array([1, 0.8, 0.6])
    raw = out / "raw" / "pretended"
    for name, values in {"reference": truth, "variance": 0 * truth, "tilt": 0 * pixel}.items():
        write_array(raw / f"{name}.f32", values)
    write_array(raw / "pixel.u32", pixel, "<u4")
    rows = []
    for method in dict.fromkeys(full_name(m) for m in option("--methods").split(",")):
        for hits in (1_000_000, 10_000_000):
            for seed in range(1, int(option("--seeds")) + 1):
                answers = Path("raw") / "pretended" / f"{len(rows)}.f32"
                noise = 0.02 * generator.normal(size=truth.shape)
                write_array(out / answers, truth * (1 + extras.get("error", 0) + noise))
                times = {f"{phase}_seconds": 0.25 for phase in ("trace", "insert", "build", "gather")}
                rows.append({"scene": "pretended", **facts_of(method), "hits_asked": hits, "hits": hits, "seed": seed, "bytes": 4096,
                             "answers": str(answers), **times})
    scene = {"file": sys.argv[2], "points": len(pixel), "width": WIDTH, "height": HEIGHT, "raw": "raw/pretended", "reference_error": 0.0}
    write_json(out, rows, {"pretended": scene})


def fit(extras):
    wait_if_slow("fit", extras, lambda *_: sys.exit(STOPPED))
    choice = {"method": "shlm/L2/radiance/surface4", "hits": 1e6, "error": 0.09, "seconds": 0.5, "bytes": 4096}
    print(json.dumps({"target": 0.1, "light_map": {"reached": True, "sure": True, "choice": choice},
                      "photon_map": {"reached": False, "sure": True, "reason": "too far"}, "light_maps": [choice] * 100}))


def wait_if_slow(command, extras, stop):
    if command in extras.get("slow", []):
        signal.signal(signal.SIGINT, stop)
        Path(sys.argv[2]).with_name(f"{os.getpid()}.ready").touch()
        while True:
            time.sleep(0.05)


def main():
    command, file = sys.argv[1], Path(sys.argv[2])
    with open(file.with_suffix(".calls"), "a", encoding="utf-8") as calls:
        calls.write(command + "\n")
    extras = json.loads(file.read_text(encoding="utf-8"))["extras"]
    if "fails" in extras or extras.get("needs", command) not in sys.argv:
        print(f"shlmbench: {extras.get('fails', 'an option is missing')}", file=sys.stderr)
        sys.exit(2)
    {"info": info, "reference": reference, "study": study, "fit": fit}[command](extras)


if __name__ == "__main__":
    main()
