"""The report in Markdown, section by section; every table says what it shows and where it comes from."""

from report.markdown import table
from report.study.first import first_rows
from report.study.groups import GROUP_TEXT, GROUP_TITLES
from report.study.slopes import FIRST_HITS, VARIANCE_OVER_BIAS
from report.study.tables import crossing_overview, crossing_table, front_table, full_table, reach_table, slope_table
from report.text import bytes_text, number_text, percent_text, seconds_text

REACH_NOTE = (
    "Where the error first falls to the target, straight between the measured sizes in log-log. 'never': what "
    "more hits do not lower (bias² of light maps and fixed radii, the variance of fixed k) is above the target "
    "even at the low end of its band. 'beyond': not reached at the largest size measured, and not forbidden. "
    "'<': reached at the smallest size already. **Bold**: first of its column; *italic*: its band reaches the "
    "winner's."
)
CROSSING_NOTE = (
    "Where shlm/L2/radiance/surface4 is smaller or more accurate than each photon map; in square brackets the band "
    "of a single crossing, from the errors alone: times are medians. 'always' and 'never' are said of the range behind them, that both were measured in. "
    "At equal bytes: the photon map of as many bytes as the light map takes, against the light map of that many "
    "hits."
)
SLOPE_NOTE = (
    "Slopes of log(error) and of log(variance) over log(hits) by least squares, with their bands. Sizes fitted: "
    f"where the variance is at least {VARIANCE_OVER_BIAS:g} x bias² (light maps, fixed radius); all from "
    f"{number_text(FIRST_HITS)} hits on (fixed or growing k). At least two sizes of two seeds; '-' where fewer "
    "are left. One band in 20 misses by chance."
)
FULL_NOTE = (
    "All that was measured. Times are medians over the seeds, wall time; FLIP is HDR-FLIP of the first seed's "
    "irradiance picture. bias² may come out below zero."
)
FRONT_NOTE = (
    "Runs that no other beats in both cost and error, in ascending order of cost, with hits (relative RMS)."
)
FIRST_NOTE = (
    "The light map and the photon map that reach the error in least time, chosen in hindsight, with the bytes of each. Time is "
    "everything until all points are answered, less what is done once for a scene. Ratio: photon map over light map, time and "
    "bytes. Errors that neither reaches are left out, but for the largest."
)


def by_scene(report, title, note, lines_of):
    """A heading, what the table says, and a table per scene; a scene without lines is left out."""
    lines = [f"## {title}", "", f"{note} {report.words}", ""]
    for scene in report.curves:
        if found := lines_of(scene):
            lines += [f"### {scene}", "", *found, ""]
    return lines


def first_lines(report):
    rows = first_rows(report.curves, report.findings)
    return ["## Who reaches an error first", "", FIRST_NOTE, "", *table(["scene", "error", "light map", "photon map", "ratio"], rows), ""]


def target_lines(report):
    found = report.findings
    return by_scene(
        report, "Time to reach an error", REACH_NOTE, lambda s: reach_table(found[s].times, seconds_text)
    ) + by_scene(
        report, "Bytes to reach an error", REACH_NOTE, lambda s: reach_table(found[s].bytes, bytes_text)
    )


def crossing_lines(report):
    overview = crossing_overview(report.findings)
    head = ["## Where the light map is more accurate at equal hits", "", *overview, ""] if overview else []
    return head + by_scene(report, "Crossings", CROSSING_NOTE, lambda s: crossing_table(report.findings[s]))


def slope_lines(report):
    return by_scene(
        report, "How fast the error falls", SLOPE_NOTE, lambda s: slope_table(report.findings[s].slopes)
    )


def full_lines(report):
    return by_scene(
        report, "Full table", FULL_NOTE, lambda s: full_table(report.curves[s], report.study.skipped(s))
    )


def front_lines(report):
    note = f"{FRONT_NOTE} {report.words}"
    return ["## Pareto fronts", "", note, "", *front_table(report.findings), ""]


def doubts(entry):
    """About whether scene and reference belong together."""
    text = ""
    if left_out := entry.get("pixels_left_out", 0):
        text += f"; {left_out} pixels left out, where it looks at another point"
    if not entry.get("reference_of_same_version", True):
        text += "; **made from another version of the scene**"
    return text


def reference_lines(report):
    lines = ["## The references", ""]
    for name in report.curves:
        scene = report.study.scenes[name]
        own = percent_text(scene.reference_error_sq)
        lines.append(f"- {name}: {scene.points} points, own RMS error {own}, eps {scene.epsilon:.3g} (W/m²)²{doubts(report.study.entry(name))}")
    return lines + [""]


def clamp_lines(report):
    """What dividing by a clamped cosine of incidence takes from the light, which only radiance weights do."""
    lines = [
        "## What the clamp of the cosine discards",
        "",
        "A hit is divided by the cosine of its incidence, but by no less than 0.001. Largest share of the stored flux that is "
        "lost to it, over all runs of a scene:",
        "",
    ]
    for scene, curves in report.curves.items():
        rows = [row for curve in curves.values() for point in curve.points for row in point.run.rows]
        shares = [row["clamped_share"] for row in rows if "clamped_share" in row]
        if shares:
            lines.append(f"- {scene}: {max(shares):.2g}")
    return lines + [""] if len(lines) > 4 else []


def group_lines(report):
    lines = ["## Which methods the charts draw", "", "All methods are in the tables.", ""]
    for group, names in report.groups.items():
        lines.append(f"- {GROUP_TITLES[group]} ({GROUP_TEXT[group]}): {', '.join(names)}")
    return lines + [""]


def missing_lines(report):
    if not report.study.problems:
        return []
    return ["## What is missing", "", *[f"- {problem}" for problem in report.study.problems], ""]


def context_lines(report):
    context = dict(report.study.context)
    libraries = context.pop("libraries", {})
    lines = ["## How this was made", "", *[f"- {key}: {value}" for key, value in context.items()]]
    return lines + [
        "- libraries: " + ", ".join(f"{name} {version}" for name, version in libraries.items()),
        "",
    ]


def markdown(report, chart_lines, image_lines):
    sections = [
        ["# Accuracy of photon maps and spherical harmonic light maps", ""],
        first_lines(report),
        target_lines(report),
        crossing_lines(report),
        slope_lines(report),
        group_lines(report),
        ["## Charts", "", *chart_lines],
        front_lines(report),
        ["## Pictures within the same cost", "", *image_lines] if image_lines else [],
        reference_lines(report),
        clamp_lines(report),
        full_lines(report),
        missing_lines(report),
        context_lines(report),
    ]
    return "\n".join(line for section in sections for line in section)
