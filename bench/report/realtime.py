"""Light maps in a fragment program: what a browser draws beside what the program answers and beside the reference, and what it costs.

Exports each scene, opens its page in a headless Chromium and takes the page's own comparison. Writes OUT/realtime.json and OUT/report.md.
"""

import argparse
import json
import statistics
import struct
import subprocess
import sys
from pathlib import Path

from report.browser import SOFTWARE_GRAPHICS, Browser, BrowserError, find_browser
from report.claims.realtime_claims import TRADITIONAL, at_most_hits, costs_by_hits
from report.markdown import table_text
from report.text import NOTHING, bytes_text, hits_text, machine_text, number_text, share_text

# L4 keeps the numbers of lower orders, too.
MAPS = ("shlm/L4/radiance", "shlm/L2/radiance", "shlm/L0/normalised", "shlm/AD/radiance", "shlm/F1/radiance", "shlm/F2/radiance", "shlm/YF2/radiance")
FILES = ("lit.glb", "lightmap.exr", "lightmap.npy", "viewer.html")
HEADS = ("scene", "basis", "exact filter: difference", "hardware filter: difference", "error, exact", "error, hardware", "error beside the traditional map's")
COST_HEADS = ("basis", "bytes a texel", "beside the traditional map", "hardware: fetches", "bytes", "exact: fetches", "bytes")


# Waits until the page shows a scene, or has said why not.
LOADED = """window.shlmViewer.then(viewer => new Promise((done, fail) => {
    const timer = setInterval(() => {
        const said = document.getElementById('said').textContent;
        if (viewer.camera || said.includes('lit.glb:')) { clearInterval(timer); viewer.camera ? done(true) : fail(new Error(said)); }
    }, 50);
}))"""


class Failed(Exception):
    """One line."""


def run(words):
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if ended.returncode:
        raise Failed(ended.stderr.strip().splitlines()[-1] if ended.stderr.strip() else f"{words[0]} ended with {ended.returncode}")


def reference_of(given, scene):
    """Of the folder of references where it is there, else made."""
    kept = given.references / f"{scene.stem}.exr"
    if kept.exists():
        return kept
    made = given.out / "work" / f"{scene.stem}-reference.exr"
    if not made.exists():
        made.parent.mkdir(parents=True, exist_ok=True)
        run([given.program, "reference", scene, "--out", made, "--width", 96, "--height", 54, "--until", given.until])
    return made


def exported(given, scene, hits, seed):
    folder = given.out / "work" / f"{scene.stem}-{hits:g}-{seed}"
    names = ",".join(f"{name}/bilinear" for name in MAPS)
    words = [given.program, "export", scene, "--method", names, "--texels", given.texels, "--hits", f"{hits:g}", "--seed", seed]
    run([*words, "--reference", reference_of(given, scene), "--out", folder])
    return folder


def normal_maps_in(glb):
    """How many materials of a binary glTF file have one."""
    data = glb.read_bytes()
    chunk = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    return sum("normalTexture" in material for material in chunk["materials"])


def compared(browser, folder):
    """What the page says of itself."""
    browser.open((folder / "viewer.html").resolve().as_uri(), 400, 200)
    if not browser.evaluate("window.shlmViewer.then(viewer => Boolean(viewer.camera))"):  # too large a scene for the page
        browser.choose("#file", (folder / "lit.glb").resolve())
        browser.evaluate(LOADED)
    return browser.evaluate("window.shlmTest()")


def measured(given, browser, scene):
    """Rows of a scene, and the bytes of its files: one run with few hits, several with many."""
    rows, files = [], {}
    for hits, seed in ((given.hits / 100, 1), *((given.hits, seed) for seed in range(1, given.seeds + 1))):
        folder = exported(given, scene, hits, seed)
        files[f"{hits:g}"] = {name: (folder / name).stat().st_size for name in FILES}
        about = json.loads((folder / "lightmap.json").read_text(encoding="utf-8"))
        result = compared(browser, folder)
        known = {"scene": scene.stem, "hits_asked": hits, "hits": about["hits"], "seed": seed, "renderer": result["renderer"]}
        rows += [{**known, **row} for row in result["rows"]]
    context = {key: value for key, value in about["context"].items() if key != "seed"}
    return context, {"scene": scene.stem, "normal_maps": normal_maps_in(folder / "lit.glb"), "atlas": about["atlas"], "files": files}, rows


def median(rows, key, **wanted):
    """Over the seeds; None where it was not measured."""
    values = [row[key] for row in rows if key in row and all(row[k] == v for k, v in wanted.items())]
    return statistics.median(values) if values else None


def medians_of(rows):
    """Of every scene, method, filter and number of hits."""
    keys = ("scene", "method", "filter", "hits_asked")
    found = []
    for values in dict.fromkeys(tuple(row[key] for key in keys) for row in rows):
        known = dict(zip(keys, values))
        found.append({**known, "rms": median(rows, "rms", **known), "error": median(rows, "error", **known)})
    return found


def cells_of(rows, scene, method):
    exact, hardware = ({"scene": scene, "method": method, "filter": name} for name in ("exact", "hardware"))
    plain = next(row["method"] for row in rows if row["method"].startswith(TRADITIONAL))
    error, traditional = median(rows, "error", **hardware), median(rows, "error", **{**hardware, "method": plain})
    beside = number_text(error / traditional, 2) if error and traditional else NOTHING
    basis = next(row["basis"] for row in rows if row["method"] == method)
    return [scene, basis, number_text(median(rows, "rms", **exact), 2), number_text(median(rows, "rms", **hardware), 2), share_text(median(rows, "error", **exact)), share_text(error), beside]


def cost_cells(rows, method):
    exact, hardware = (next(r for r in rows if r["method"] == method and r["filter"] == f) for f in ("exact", "hardware"))
    plain = next(r for r in rows if r["method"].startswith(TRADITIONAL) and r["filter"] == "hardware")
    return [exact["basis"], str(exact["texel_bytes"]), number_text(exact["texel_bytes"] / plain["texel_bytes"], 2), str(hardware["fetches"]), str(hardware["bytes"]),
            str(exact["fetches"]), str(exact["bytes"])]


def markdown(document):
    rows = at_most_hits(document)
    most = rows[0]["hits_asked"]
    methods = list(dict.fromkeys(row["method"] for row in rows))
    scenes = [entry["scene"] for entry in document["scenes"]]
    sizes = [[entry["scene"], f"{entry['atlas']['width']} x {entry['atlas']['height']}", *(bytes_text(entry["files"][f"{most:g}"][name]) for name in FILES)] for entry in document["scenes"]]
    constant = all(len(found) == 1 for found in costs_by_hits(document).values())
    words = "The cost of a fragment is the same at both numbers of hits." if constant else "THE COST OF A FRAGMENT DEPENDS ON THE HITS."
    return "\n".join([
        "# Light maps in a fragment program", "",
        f"Pixels drawn by {rows[0]['renderer']}; {hits_text(most)} hits; medians of {len({row['seed'] for row in rows})} seeds; {machine_text(document['context'])}.", "",
        table_text(HEADS, [cells_of(rows, scene, method) for scene in scenes for method in methods]),
        "Differences are relative RMS beside the program's own answers at the points that the stored camera sees; errors are relative RMS against the reference there.", "",
        table_text(COST_HEADS, [cost_cells(rows, method) for method in methods]),
        f"{words} Fetches of a fragment, and the bytes that they read: four texels each where the graphics card mixes. Normal and colour textures are not counted.", "",
        table_text(("scene", "picture, pixels", *FILES), sizes),
    ])


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="bench/report realtime", description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path, help="shlmbench")
    parser.add_argument("out", type=Path)
    parser.add_argument("scenes", type=Path, nargs="+", help="glTF 2.0 files")
    parser.add_argument("--references", type=Path, default=Path("results/references"), help="folder of SCENE.exr; what is not there is made")
    parser.add_argument("--until", default="1%", help="error of references that are made")
    parser.add_argument("--hits", type=float, default=1e7, help="the second number of hits, 100 times the first")
    parser.add_argument("--texels", default="65536")
    parser.add_argument("--seeds", type=int, default=3, help="runs at the second number of hits")
    return parser.parse_args(arguments)


def main(arguments):
    given = parsed(arguments)
    if not find_browser():
        print("bench/report realtime: no Chromium is installed", file=sys.stderr)
        return 2
    document = {"context": {}, "scenes": [], "rows": []}
    browser = Browser(find_browser(), SOFTWARE_GRAPHICS)
    try:
        for scene in given.scenes:
            print(scene.stem, file=sys.stderr)
            document["context"], about, rows = measured(given, browser, scene)
            document["scenes"].append(about)
            document["rows"] += rows
    except (Failed, BrowserError, OSError) as error:
        print(f"bench/report realtime: {error}", file=sys.stderr)
        return 2
    finally:
        browser.close()
    document["medians"] = medians_of(document["rows"])
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "realtime.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    (given.out / "report.md").write_text(markdown(document), encoding="utf-8")
    print(f"{given.out / 'report.md'}")
    return 0 if all(row["passed"] for row in document["rows"]) else 1
