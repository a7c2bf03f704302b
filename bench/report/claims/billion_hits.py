"""The paper's headline: a billion hits on a desktop PC, and where the photon map's memory ends."""

from report.claims.finding import NOT_DECIDED, NOT_MEASURED, NOT_MEASURED_YET, Finding, sentence
from report.claims.judging import has_enough_runs, range_text, runs_of
from report.compare.baselines import is_exact, one_per_engine
from report.compare.comparison import INCREMENTAL, map_seconds
from report.compare.memory_wall import growth, wall_bytes
from report.text import bytes_text, count_text

BILLION, BESIDE = 10**9, 10**7
SAYS = "Over a billion hits on a desktop PC"


def light_map_text(comparison, scene):
    """Empty without a row of a billion hits."""
    rows = [row for row in comparison.series(scene, comparison.light_map) if row["hits"] >= BILLION]
    if not rows:
        return ""
    row, small = rows[-1], comparison.row(scene, comparison.light_map, BESIDE)
    def peak(r):
        return bytes_text(r["peak_growth_bytes"]) if r and "peak_growth_bytes" in r else "not measured"

    return (f"{scene}: {count_text(row['hits'])} hits in {map_seconds(row):.0f} s ({row['hits'] / map_seconds(row) / 1e6:.1f} M hits/s, "
            f"{row['threads']} threads), at its fullest {peak(row)} beside the scene; at 1e7 hits {peak(small)}")


def wall_text(comparison, scene, method):
    """How far this photon map goes: measured, at the wall, and what a billion hits would take. Empty where too little is known."""
    grows, wall = growth(comparison, scene, method), wall_bytes(comparison, scene)
    if not grows or not wall:
        return ""
    last = grows.rows[-1]
    if last["hits"] >= BILLION:
        return f"{method} on {scene}: {count_text(last['hits'])} hits with {bytes_text(last['peak_growth_bytes'])}"
    return (f"{method} on {scene}: measured up to {count_text(last['hits'])} hits, the wall of {bytes_text(wall)} stands at "
            f"{count_text(grows.hits_at(wall))} hits, a billion would take {bytes_text(grows.bytes_at(BILLION))} (extrapolated)")


def verdict_against(comparison, methods):
    """Confirmed where the photon map's memory ends before a billion hits in every scene that has them as a light map."""
    seen, fits = False, []
    for scene in comparison.scenes:
        if not light_map_text(comparison, scene):
            continue
        for method in methods:
            if (grows := growth(comparison, scene, method)) and (wall := wall_bytes(comparison, scene)):
                seen = True
                fits.append(grows.bytes_at(BILLION) <= wall)
    if not seen:
        return NOT_MEASURED
    return "no difference: it fits as well" if any(fits) else "confirmed"


def billion_hits(comparison):
    light = [text for scene in comparison.scenes if (text := light_map_text(comparison, scene))]
    photon_maps = one_per_engine(comparison)
    walls = [text for scene in comparison.scenes for method in photon_maps if (text := wall_text(comparison, scene, method))]
    text = "; ".join(light) + "." if light else "No row of the light map with 1e9 hits: not measured."
    text += " Photon maps: " + ("; ".join(walls) + "." if walls else "not measured at a million hits and more, or without their peaks.")
    if not light:
        return Finding("billion-hits", SAYS, NOT_MEASURED_YET, text)
    rows = [row for scene in comparison.scenes for row in comparison.series(scene, comparison.light_map) if row["hits"] >= BILLION]
    enough = all(has_enough_runs(row) for row in rows)
    condition = "" if enough else "done in every run that was made, but in fewer than 3 a scene"
    speeds = [row["hits"] / map_seconds(row) / 1e6 for row in rows]
    return Finding("billion-hits", SAYS, "confirmed" if enough else NOT_DECIDED, text, verdict_against(comparison, [INCREMENTAL]),
                   verdict_against(comparison, [method for method in photon_maps if is_exact(comparison, method)]),
                   condition=condition, plain=sentence(condition),
                   figure=f"{range_text(speeds, '{:.1f}')} M hits/s", scenes=tuple(row["scene"] for row in rows), runs=runs_of(rows))
