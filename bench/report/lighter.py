"""Light maps that need less: bases side by side, direct light apart, and photons spread by a sequence.

    bench/report lighter OUT

OUT has the folders of studies, `photons` and `traced`: the same methods with all light from photons, and with direct
light apart. Also, where they were made, pairs whose emission alone differs: `random-photons` and `sobol-photons`,
`random-traced` and `sobol-traced`. Writes OUT/lighter.json and OUT/lighter.md.
"""

import json
import math
import sys
from pathlib import Path

import numpy as np

from report.markdown import table_text
from report.text import machine_text

FAMILIES = {"shlm": "light map", "photonmap": "photon map"}
DIRECT = ("photons", "traced")
TARGETS = (0.05, 0.02, 0.01)


def percent(error_sq):
    return 100 * math.sqrt(max(error_sq, 0.0))


def best_at_each_size(methods):
    """[(hits, squared error, method)] of the least error at each number of hits, ascending."""
    best = {}
    for name, points in methods.items():
        for point in points:
            asked = point["hits_asked"]
            if asked not in best or point["error"] < best[asked][1]:
                best[asked] = (point["hits"], point["error"], name)
    return [best[asked] for asked in sorted(best)]


def slope(best):
    """Of log(squared error) over log(hits), least squares."""
    hits, errors = np.log([hits for hits, *_ in best]), np.log([error for _, error, _ in best])
    return float(np.polyfit(hits, errors, 1)[0]) if len(best) > 1 else None


def hits_to(best, target):
    """Straight between sizes in log-log; None beyond the largest."""
    for (low, before, _), (high, after, _) in zip(best, best[1:]):
        if after <= target**2 < before:
            share = math.log(before / target**2) / math.log(before / after)
            return low * (high / low) ** share
    return best[0][0] if best and best[0][1] <= target**2 else None


def seconds_to(methods, target):
    """Of the run that gets there first, whole: preparation apart, everything to the last answer."""
    times = [point["total_seconds"] for points in methods.values() for point in points if point["error"] <= target**2]
    return min(times, default=None)


def family_rows(scene, name):
    """What the methods of each family reach together."""
    rows = []
    for family in FAMILIES:
        methods = {m: points for m, points in scene["methods"].items() if m.startswith(family + "/")}
        best = best_at_each_size(methods)
        row = {"scene": name, "family": family, "slope": slope(best)}
        row["best"] = [{"hits": hits, "error": math.sqrt(max(error, 0.0)), "method": method} for hits, error, method in best]
        row["reached"] = [{"target": t, "hits": hits_to(best, t), "seconds": seconds_to(methods, t)} for t in TARGETS]
        rows.append(row)
    return rows


def basis_of(name):
    """Basis and weight of a light map's name."""
    return "/".join(name.split("/")[1:3])


def basis_rows(scene, name):
    """The least error of each basis, over numbers of texels."""
    rows = []
    bases = dict.fromkeys(basis_of(m) for m in scene["methods"] if m.startswith("shlm/"))
    for basis in bases:
        methods = {m: points for m, points in scene["methods"].items() if m.startswith("shlm/") and basis_of(m) == basis}
        for hits, error, method in best_at_each_size(methods):
            point = next(p for p in methods[method] if p["hits"] == hits)
            row = {"scene": name, "basis": basis, "hits_asked": point["hits_asked"], "error": math.sqrt(max(error, 0.0))}
            rows.append(row | {"method": method, "bytes": point["bytes"], "seconds": point["total_seconds"]})
    return rows


def emission_rows(random, sobol, direct):
    rows = []
    for scene, found in random["scenes"].items():
        for method, points in found["methods"].items():
            for a, b in zip(points, sobol["scenes"][scene]["methods"][method]):
                row = {"direct": direct, "scene": scene, "method": method, "hits_asked": a["hits_asked"]}
                rows.append(row | {"variance_ratio": a["variance"] / b["variance"], "error_random": math.sqrt(a["error"]), "error_sobol": math.sqrt(b["error"])})
    return rows


def summary_of(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def document_of(out):
    """All figures."""
    document = {"context": summary_of(out / "photons")["context"], "families": {}, "bases": {}, "emission": []}
    for direct in DIRECT:
        scenes = summary_of(out / direct)["scenes"]
        document["families"][direct] = [row for name, scene in scenes.items() for row in family_rows(scene, name)]
        document["bases"][direct] = [row for name, scene in scenes.items() for row in basis_rows(scene, name)]
        pair = [out / f"{emission}-{direct}" for emission in ("random", "sobol")]
        if all((folder / "summary.json").exists() for folder in pair):
            document["emission"] += emission_rows(*map(summary_of, pair), direct)
    return document


def number(value, form="{:.3g}"):
    return "-" if value is None else form.format(value)


def direct_table(document):
    rows = []
    for a, b in zip(*(document["families"][direct] for direct in DIRECT)):
        row = [a["scene"], FAMILIES[a["family"]], f"{number(a['slope'], '{:.2f}')} / {number(b['slope'], '{:.2f}')}"]
        for x, y in zip(a["reached"], b["reached"]):
            row.append(f"{number(x['hits'])} / {number(y['hits'])}")
            row.append(f"{number(x['seconds'])} / {number(y['seconds'])}")
        rows.append(row)
    heads = ["scene", "method", "slope"] + [f"{what} to {100 * t:g} %" for t in TARGETS for what in ("hits", "seconds")]
    return table_text(heads, rows)


def error_table(document):
    sizes = sorted({round(point["hits"], -3) for row in document["families"]["photons"] for point in row["best"]})
    rows = []
    for a, b in zip(*(document["families"][direct] for direct in DIRECT)):
        cells = [f"{percent(x['error'] ** 2):.3g} / {percent(y['error'] ** 2):.3g}" for x, y in zip(a["best"], b["best"])]
        rows.append([a["scene"], FAMILIES[a["family"]], *cells, *["-"] * (len(sizes) - len(cells))])
    return table_text(["scene", "method", *[f"{size:.0e}" for size in sizes]], rows)


def bases_table(document, direct):
    rows, found = [], document["bases"][direct]
    bases = list(dict.fromkeys(row["basis"] for row in found))
    cells = {}
    for row in found:
        cells.setdefault((row["scene"], row["hits_asked"]), {})[row["basis"]] = f"{percent(row['error'] ** 2):.2f}"
    for (scene, asked), errors in cells.items():
        rows.append([scene, f"{asked:.0e}", *[errors.get(basis, "-") for basis in bases]])
    return table_text(["scene", "hits", *bases], rows)


def emission_table(document):
    """The ratios' medians over scenes' methods of a family."""
    groups = {}
    for row in document["emission"]:
        groups.setdefault((row["scene"], row["method"].split("/")[0], row["direct"]), {}).setdefault(row["hits_asked"], []).append(row["variance_ratio"])
    sizes = sorted({row["hits_asked"] for row in document["emission"]})
    rows = [[scene, FAMILIES[family], direct, *[f"{np.median(ratios[size]):.2f}" for size in sizes]] for (scene, family, direct), ratios in groups.items()]
    return table_text(["scene", "method", "direct light", *[f"{size:.0e}" for size in sizes]], rows)


def text_of(document):
    parts = [
        "# Light maps that need less: the figures",
        machine_text(document["context"]),
        "Error is the square root of the mean of squared relative errors, in %; of each kind the best number of texels, k or radius counts.",
        "## Direct light apart",
        "Photons of all light / direct light traced. The slope is that of the squared error over hits.",
        direct_table(document),
        "Least error in %:",
        error_table(document),
        "## Bases",
        "Least error in % over numbers of texels, photons of all light:",
        bases_table(document, "photons"),
        "With direct light traced:",
        bases_table(document, "traced"),
    ]
    if document["emission"]:
        parts += ["## Emission", "Variance with independent photons over that with the sequence, median over methods:", emission_table(document)]
    return "\n\n".join(part.rstrip("\n") for part in parts) + "\n"


def main(arguments):
    out = Path(arguments[0])
    missing = [out / direct / "summary.json" for direct in DIRECT if not (out / direct / "summary.json").exists()]
    if missing:
        print(f"bench/report: there is no {missing[0]}; ./reproduce --lighter makes it", file=sys.stderr)
        return 2
    document = document_of(out)
    (out / "lighter.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    (out / "lighter.md").write_text(text_of(document), encoding="utf-8")
    print(out / "lighter.md")
    return 0
