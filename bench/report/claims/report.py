"""Writes FOLDER/report.md from FOLDER/compare.json, and from a study's summary.json if there is one, and prints the
verdicts: bench/report claims FOLDER [STUDY_FOLDER]"""

import sys
from pathlib import Path

from report.claims.claims import findings
from report.claims.finding import NOT_MEASURED_YET
from report.claims.verdicts import read_summary
from report.compare.baselines import INSERT_NS
from report.compare.comparison import LIGHT_MAP, LIGHT_MAP_FLUX, PAPER_LIGHT_MAP, PHOTON_MAP, Comparison
from report.markdown import table
from report.text import NOTHING, count_text, number_text

CHARTS = {
    "time-to-map": "Time until a map answers: the empty store, trace, insert, build. Dotted: tracing with no store.",
    "insert": "What a run with the store takes longer than the same run without one, per hit and thread.",
    "gather": "Time to ask a finished map, at the points the camera sees. Dashed: the same points shuffled.",
    "bytes": "Bytes of the finished map. Dashed: the light map's sums while it is filled.",
    "memory-wall": "What a run adds to the process at its fullest, with the bound of `--max-memory`. Points are measured; dashed lines are straight "
    "from the last two of them, crosses are where a method would meet the wall, figures at the right are bytes at a billion hits, \u2248 where extrapolated.",
}
LIGHT_MAPS = {
    LIGHT_MAP: "the default",
    PAPER_LIGHT_MAP: "asked as in the paper: the nearest texels are taken whatever surface they are of",
}
STRONGEST = (
    "The strongest engine is found by measurement: of the exact photon maps with a row of the same scene and number of hits, the one whose figure "
    "is least, the figure being the claim's own: seconds to a finished map, ns per hit with its share of the build, bytes of the map, time of a gather. "
    "Among gathers those compete whose error is no greater than that of k50/disc, by the study; without one, only k50/disc."
)


def claims_table(comparison, study):
    heads = ("claim", "the paper says", "verdict", "against flann-incremental", "against the strongest engine", "measured")
    measured = [f for f in findings(comparison, study) if f.verdict != NOT_MEASURED_YET]
    return table(heads, [(f.claim, f.says, f"**{f.verdict}**", f.incremental, f.strongest, f.measured) for f in measured])


def added_text(row):
    return f"{row['peak_growth_bytes'] / 2**20:.0f}" if "peak_growth_bytes" in row else row.get("peak_rss_note", "")


def mebibytes(row, key):
    """`-` where an older table has not got it."""
    return f"{row[key] / 2**20:.1f}" if key in row else NOTHING


def scene_table(comparison, scene):
    lines = [
        "| method | hits | repetitions | prepare s, once a scene | trace s | insert ns/hit | build s | gather us | shuffled us "
        "| prepared MiB | while filled MiB | finished MiB | peak RSS MiB | of that added MiB | mean irradiance W/m^2 |",
        "|" + 15 * "---|",
    ]
    for row in (r for r in comparison.rows if r["scene"] == scene):
        if "skipped" in row:
            lines.append(f"| {row['method']} | {count_text(row['hits_asked'])} | skipped: {row['skipped']} |" + 12 * " |")
            continue
        lines.append(
            f"| {row['method']} | {row['hits']} | {row['repetitions']} | {number_text(row.get('prepare_seconds'))} | {row['trace_seconds']:.3g} | {INSERT_NS.value(row):.1f} "
            f"| {row['build_seconds']:.3g} | {row['gather_us_per_query']:.2f} | {row['gather_us_per_query_shuffled']:.2f} "
            f"| {mebibytes(row, 'prepare_bytes')} | {mebibytes(row, 'insert_bytes')} | {mebibytes(row, 'bytes')} | {row['peak_rss_bytes'] / 2**20:.0f} | {added_text(row)} | {row['mean_irradiance']:.4g} |"
        )
    return lines


def weight_table(comparison):
    """The two readings of the paper, side by side with the photon map."""
    heads, cells = ("scene", "hits", "photon map", "SHLM radiance", "SHLM flux", "flux / radiance"), []
    for scene in comparison.scenes:
        rows = [comparison.series(scene, m) for m in (PHOTON_MAP, LIGHT_MAP, LIGHT_MAP_FLUX)]
        if all(rows):
            photons, radiance, flux = (series[-1] for series in rows)
            means = [row["mean_irradiance"] for row in (photons, radiance, flux)]
            cells.append([scene, count_text(radiance["hits"]), *(f"{mean:.4g}" for mean in means), f"{means[2] / means[1]:.3f}"])
    return table(heads, cells) if cells else []


def images(comparison):
    """All engines of a photon map find the same photons: one picture for all, by the first that has one."""
    lines = []
    for scene in comparison.scenes:
        shown = set()
        for method in comparison.methods:
            name = f"images/{scene}-{method.replace('/', '-')}.png"
            picture = method.replace(f"/{comparison.engine(method)}/", "/")
            measured = comparison.series(scene, method)
            if not measured or picture in shown or not (comparison.folder / name).exists():
                continue
            shown.add(picture)
            hits = measured[-1]["hits"]
            lines += [f"**{scene}, {method}**, {count_text(hits)} hits", "", f"![{scene}, {method}]({name})", ""]
    return lines


def context_lines(comparison, study):
    context = dict(comparison.context)
    libraries = context.pop("libraries")
    lines = [f"- {key}: {value}" for key, value in context.items()]
    lines.append("- libraries: " + ", ".join(f"{name} {version}" for name, version in libraries.items()))
    if study:
        made = study["context"]
        lines.append(f"- errors: from the study of commit {made['commit']}, built {made['built']}, seeds and sizes in its report")
    return lines


def report(comparison, study):
    lines = ["# Photon maps and spherical harmonic light maps, measured side by side", ""]
    lines += ["## The paper's claims", "", STRONGEST, ""]
    for light_map, words in LIGHT_MAPS.items():
        if light_map in comparison.methods:
            lines += [f"Of {light_map}, {words}.", "", *claims_table(comparison.judging(light_map), study), ""]
    lines += ["## Charts", ""]
    for name, text in CHARTS.items():
        lines += [text, "", f"![{name}](charts/{name}.png)", ""]
    if weights := weight_table(comparison):
        lines += [
            "## What a hit stands for: flux or radiance",
            "",
            "The paper treats a photon as a directional light but leaves its strength open. A hit of flux F on texel area a, at incidence theta, is "
            "F/a on the surface and F/(a cos theta) on a plane that faces the light. With the 1/cos (radiance, the default) the light "
            "map agrees with the photon map; without it (flux, the paper read literally) uniform light reads 0.66 of the truth. "
            "Mean irradiance over the query points, W/m^2; one seed, no confidence band.",
            "",
            *weights,
            "",
        ]
    lines += ["## Table", "", "Medians; trace s is tracing without a store, by wall clock. Insert ns is what the run takes longer than without a store, per hit and thread.", ""]
    for scene in comparison.scenes:
        lines += [f"### {scene}", "", *scene_table(comparison, scene), ""]
    lines += ["## Images", "", "One gather per pixel, normal maps applied, the same exposure for all methods of a scene. Engines of a photon map find the same photons: one picture for all.", "", *images(comparison)]
    lines += ["## How this was made", "", *context_lines(comparison, study), ""]
    return "\n".join(lines)


def main(arguments):
    try:
        comparison = Comparison(arguments[0])
        study = read_summary(arguments[1]) if len(arguments) > 1 else None
    except (OSError, ValueError, KeyError) as error:
        print(f"bench/report claims: {error}", file=sys.stderr)
        return 2
    (comparison.folder / "report.md").write_text(report(comparison, study), encoding="utf-8")
    found = findings(comparison, study)
    width = max(len(f.claim) for f in found)
    for finding in found:
        sides = f"[flann-incremental: {finding.incremental}; strongest: {finding.strongest}]  " if finding.incremental else ""
        print(f"{finding.claim:<{width}}  {finding.verdict:<16}  {sides}{finding.measured}")
    print(f"\n{comparison.folder / 'report.md'}")
    return 0
