"""The paper's claims about accuracy, held against a study's summary.json."""

import math

from report.claims.finding import NOT_DECIDED, Finding, not_measured, sentence
from report.claims.judging import RUNS_OF_LARGE, range_text
from report.study.methods import REFERENCE_LIGHT_MAP, REFERENCE_PHOTON_MAP, TRADITIONAL_LIGHT_MAP

NORMAL_MAPS = ("normal-maps", "The map lights normal-mapped surfaces")
CONVERGES = ("converges", "Accumulation can go on indefinitely, to maximum convergence")

STAYS = "the noise vanishes, the blur of the texels and the truncation of the series stay"
SLOPE_TOLERANCE = 0.1  # from -1, for noise that falls as 1 / hits
CLEARLY_BETTER = 4.0  # in bias^2: half of the relative bias
TILTED = 20.0  # degrees between shading and geometric normal from which on a surface counts as tilted
ORDERS = ("shlm/F1/radiance/surface4", "shlm/F2/radiance/surface4", "shlm/L4/radiance/surface4")


def percent(square):
    """Of the root of a squared relative error."""
    return f"{100 * math.sqrt(max(square, 0.0)):.2g} %"


def count(value):
    return f"{value:.2g}"


def default_texels(summary):
    settings = dict(part.split("=") for part in summary["context"]["settings"].split())
    return int(settings["texels"].split(",")[-1])


def largest(points):
    return max(points, key=lambda p: p["hits"])


# --- converges


def own_hits(light_map):
    """Its blocks of texels shrink with the hits until texels show their own: this one's always do."""
    return light_map + "/h0"


def variance_slope(scene, light_map):
    for method in (own_hits(light_map), light_map):
        if slope := scene["slopes"].get(method, {}).get("variance"):
            return slope["value"]
    return None


def floor_words(name, scene, light_map, texels):
    """What the error comes down to, and from how many hits per texel on more of them are in vain."""
    last = largest(scene["methods"][light_map])
    text = f"{name}: variance ~ hits^{variance_slope(scene, light_map):.2f}, error {percent(last['error'])} at {count(last['hits'])} hits"
    if last["bias_sq"] > 0 and last["bias_sq_band"] and last["bias_sq_band"][0] > 0:
        hits = last["hits"] * last["variance"] / last["bias_sq"]
        text += f", floor {percent(last['bias_sq'])}, where the noise is at {count(hits / texels)} hits per texel"
    return text


def converges(summary, light_map=REFERENCE_LIGHT_MAP):
    scenes = {
        name: scene
        for name, scene in summary["scenes"].items()
        if light_map in scene["methods"] and variance_slope(scene, light_map) is not None
    }
    if not scenes:
        return not_measured(*CONVERGES)
    texels = default_texels(summary)
    noise_falls = all(abs(variance_slope(s, light_map) + 1) < SLOPE_TOLERANCE for s in scenes.values())
    last = [largest(s["methods"][light_map]) for s in scenes.values()]
    has_floor = any(p["bias_sq_band"] and p["bias_sq_band"][0] > 0 for p in last)
    verdict = "refuted" if not noise_falls else "conditional" if has_floor else "confirmed"
    runs = seeds_of(summary, scenes, light_map)
    if runs and runs[0] < RUNS_OF_LARGE:
        verdict = NOT_DECIDED
    condition = STAYS if verdict == "conditional" else ""
    errors = [100 * math.sqrt(p["error"]) for p in last]
    floor = f"The noise falls as 1 / hits (its slope within {SLOPE_TOLERANCE:g} of -1) over all sizes measured; what stays is the texels' blur and the truncated series, which more hits do not lower. "
    return Finding(
        *CONVERGES,
        verdict,
        (floor if verdict == "conditional" else "")
        + "; ".join(floor_words(name, scene, light_map, texels) for name, scene in scenes.items())
        + f" ({light_map}, {texels} texels; slopes of {own_hits(light_map)} where it was measured).",
        condition=condition,
        plain=sentence(condition),
        figure=f"error {range_text(errors, '{:.2g}')} % at {count(max(p['hits'] for p in last))} hits",
        scenes=tuple(scenes),
        runs=runs,
    )


# --- normal maps


def tilted_bias(points):
    """(squared relative bias, upper end of its band, points) of the largest run, over the points with tilted normals."""
    bins = [b for b in largest(points)["tilt"] if b["degrees"][0] >= TILTED]
    total = sum(b["points"] for b in bins)
    if not total or any(b["bias_sq_band"] is None for b in bins):
        return None
    value = sum(b["bias_sq"] * b["points"] for b in bins) / total
    return value, sum(b["bias_sq_band"][1] * b["points"] for b in bins) / total, total


def bias_words(points):
    """A bias that is lost in the noise has an upper bound only."""
    value, high, _ = tilted_bias(points)
    return percent(value) if value > high / 4 else f"at most {percent(high)}"


def bent_normals(scene, light_map):
    """(the light map's squared bias where normals are bent, its upper end, points, the traditional light map's); None where
    there are no such points."""
    methods = scene["methods"]
    if any(m not in methods or not tilted_bias(methods[m]) for m in (light_map, TRADITIONAL_LIGHT_MAP)):
        return None
    (mine, most, points), (flat, _, _) = (tilted_bias(methods[m]) for m in (light_map, TRADITIONAL_LIGHT_MAP))
    return mine, most, points, flat


def verdict_on_normals(mine, most, flat):
    return "confirmed" if most < flat / CLEARLY_BETTER else "refuted" if mine >= flat else "conditional"


def bent_normals_words(name, scene, light_map, points, flat):
    methods = scene["methods"]
    measured = [(m, methods[m]) for m in (light_map, *ORDERS, REFERENCE_PHOTON_MAP) if m in methods and tilted_bias(methods[m])]
    return (
        f"{name}, {points} points, {count(largest(methods[light_map])['hits'])} hits: "
        + ", ".join(f"{m} {bias_words(of_method)}" for m, of_method in measured)
        + f"; a traditional light map, which knows one normal, {percent(flat)}"
    )


def normal_maps(summary, light_map=REFERENCE_LIGHT_MAP):
    scenes = {name: found for name, scene in summary["scenes"].items() if (found := bent_normals(scene, light_map))}
    if not scenes:
        return not_measured(*NORMAL_MAPS)
    verdicts = {name: verdict_on_normals(mine, most, flat) for name, (mine, most, _, flat) in scenes.items()}
    runs = seeds_of(summary, scenes, light_map)
    words = [bent_normals_words(name, summary["scenes"][name], light_map, points, flat) for name, (_, _, points, flat) in scenes.items()]
    biases = [100 * math.sqrt(max(0.0, mine)) for mine, _, _, _ in scenes.values()]
    flats = [100 * math.sqrt(flat) for *_, flat in scenes.values()]
    differing = "" if len(set(verdicts.values())) == 1 else "; ".join(f"{name} {verdict}" for name, verdict in verdicts.items())
    return Finding(
        *NORMAL_MAPS,
        decided(verdicts, runs),
        f"Relative RMS bias where the normal is bent by {TILTED:.0f} degrees and more (confirmed: the light map's band is below half of what a "
        f"traditional one has): {'. '.join(words)}.",
        condition=differing,
        plain=f"By scene: {differing}." if differing else "",
        figure=f"bias {range_text(biases, '{:.2g}')} % beside {range_text(flats, '{:.2g}')} %",
        scenes=tuple(scenes),
        runs=runs,
    )


def seeds_of(summary, scenes, light_map):
    """Fewest and most seeds of the largest runs; empty where a summary does not say."""
    seeds = [largest(summary["scenes"][name]["methods"][light_map]).get("seeds") for name in scenes]
    return () if None in seeds else (min(seeds), max(seeds))


def decided(verdicts, runs):
    """One verdict for all scenes, of enough runs."""
    if runs and runs[0] < RUNS_OF_LARGE:
        return NOT_DECIDED
    kinds = set(verdicts.values())
    return kinds.pop() if len(kinds) == 1 else "conditional"


# --- smaller, and more accurate


def crossing_words(less, texels):
    """In hits of the light map and hits per texel."""
    if not less or not less["range"]:
        return "not comparable"
    if not less["intervals"]:
        return f"nowhere up to {count(less['range'][1])}"
    if less["crossing"]:
        open_end = less["intervals"][0][1] is None
        side = "from" if open_end else "up to"
        return f"{side} {count(less['crossing'])} hits ({count(less['crossing'] / texels)} per texel)"
    return "everywhere" if less["intervals"] == [[None, None]] else "in several ranges"


def accuracy_crossings(summary):
    """Where the light map is smaller, and more accurate at equal hits, than the photon map with k = 50."""
    texels = default_texels(summary)
    words = []
    for name, scene in summary["scenes"].items():
        crossing = scene["more_accurate_than"].get(REFERENCE_PHOTON_MAP)
        if crossing:
            words.append(
                f"{name}: smaller {crossing_words(scene['smaller_than_reference_photon_map'], texels)}, "
                f"more accurate {crossing_words(crossing['hits'], texels)}"
            )
    return f"Against k = 50, {REFERENCE_LIGHT_MAP} is at equal hits " + "; ".join(words) + "." if words else ""
