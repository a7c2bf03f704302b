"""The paper's claims about its fragment program, held against a realtime.json."""

from report.claims.finding import NOT_DECIDED, Finding, not_measured
from report.claims.judging import RUNS_OF_LARGE, range_text
from report.claims.study_claims import NORMAL_MAPS
from report.text import number_text

REALTIME = ("realtime", "A fragment is lit by evaluating the basis for its normal, whatever the number of photons")
LARGEST_DIFFERENCE = 1e-4  # relative RMS beside the program's own answers, of exact filtering
CLEARLY_BETTER = 2.0  # times the traditional light map's error
LIGHT_MAP, TRADITIONAL = "shlm/L2/radiance", "shlm/L0/normalised"
COSTS = ("fetches", "bytes", "texel_bytes")


def seeds_of(rows):
    """Fewest and most of a scene at the most hits."""
    counts = [len({r["seed"] for r in rows if r["scene"] == scene}) for scene in {r["scene"] for r in rows}]
    return (min(counts), max(counts)) if counts else ()


def at_most_hits(document):
    most = max(row["hits_asked"] for row in document["rows"])
    return [row for row in document["rows"] if row["hits_asked"] == most]


def costs_by_hits(document):
    """(method, filter) -> what its fragments cost, at each number of hits."""
    costs = {}
    for row in document["rows"]:
        costs.setdefault((row["method"], row["filter"]), set()).add(tuple(row[key] for key in COSTS))
    return costs


def realtime(document):
    if len({row["hits_asked"] for row in document["rows"]}) < 2:
        return not_measured(*REALTIME)
    exact = [row["rms"] for row in document["rows"] if row["filter"] == "exact"]
    costs = costs_by_hits(document)
    same, right = all(len(found) == 1 for found in costs.values()), max(exact) <= LARGEST_DIFFERENCE
    rows = at_most_hits(document)
    of_light_map = next(r for r in rows if r["method"].startswith(LIGHT_MAP) and r["filter"] == "hardware")
    runs = seeds_of(rows)
    verdict = NOT_DECIDED if runs[0] < RUNS_OF_LARGE else "confirmed" if same and right else "refuted"
    sizes = sorted({row["hits_asked"] for row in document["rows"]})
    return Finding(
        *REALTIME,
        verdict,
        f"Of every basis, fragments {'cost the same' if same else 'do NOT cost the same'} at {' and '.join(f'{hits:.0e}' for hits in sizes)} hits. Pixels with exact filtering differ from the "
        f"program's answers by at most {max(exact):.1e} relative RMS (bound {LARGEST_DIFFERENCE:.0e}). {LIGHT_MAP}: {of_light_map['fetches']} fetches of {of_light_map['bytes']} bytes where the graphics "
        f"card filters. Times are not measured: no graphics card is at hand.",
        figure=f"order 2: {of_light_map['fetches']} fetches, {of_light_map['bytes']} bytes a fragment",
        scenes=tuple(dict.fromkeys(r["scene"] for r in rows)),
        runs=runs,
    )


def errors_of(rows, scene, method):
    return [r["error"] for r in rows if r["scene"] == scene and r["method"].startswith(method) and r["filter"] == "hardware" and "error" in r]


def normal_maps(document):
    """As drawn, with the filter that engines use: all points that the camera sees."""
    rows = at_most_hits(document)
    bent = [entry["scene"] for entry in document["scenes"] if entry["normal_maps"] > 0]
    pairs = {scene: (errors_of(rows, scene, LIGHT_MAP), errors_of(rows, scene, TRADITIONAL)) for scene in bent}
    pairs = {scene: pair for scene, pair in pairs.items() if all(pair)}
    if not pairs:
        return not_measured(*NORMAL_MAPS)
    verdicts = {}
    for scene, (mine, flat) in pairs.items():
        verdicts[scene] = "confirmed" if max(mine) * CLEARLY_BETTER < min(flat) else "refuted" if min(mine) >= max(flat) else "conditional"
    runs = seeds_of([r for r in rows if r["scene"] in pairs])
    kinds = set(verdicts.values())
    verdict = NOT_DECIDED if runs[0] < RUNS_OF_LARGE else kinds.pop() if len(kinds) == 1 else "conditional"
    words = [f"{scene} {number_text(100 * max(mine))} % beside {number_text(100 * min(flat))} %" for scene, (mine, flat) in pairs.items()]
    clearly = [scene for scene, found in verdicts.items() if found == "confirmed"]
    rest = [scene for scene in verdicts if scene not in clearly]
    plain = f"Drawn in a browser, its error is below half of a traditional map's in {', '.join(clearly)}, not in {', '.join(rest)}." if clearly and rest else ""
    return Finding(
        *NORMAL_MAPS,
        verdict,
        f"Drawn by a fragment program with the graphics card's filter, relative RMS error at the points that the camera sees, {LIGHT_MAP} beside {TRADITIONAL}, a traditional light map "
        f"(confirmed: below half of its error in every run): {'; '.join(words)}.",
        condition="; ".join(f"{scene} {found}" for scene, found in verdicts.items()) if rest else "",
        plain=plain,
        figure=f"error {range_text([100 * max(m) for m, _ in pairs.values()], '{:.2g}')} % beside {range_text([100 * min(f) for _, f in pairs.values()], '{:.2g}')} %",
        scenes=tuple(pairs),
        runs=runs,
    )


def measured_by_fragments(document):
    return [normal_maps(document), realtime(document)]
