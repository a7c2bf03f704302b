"""report.md of the scenes that others made."""

from report.elsewhere.images import WORDS
from report.elsewhere.record import error_of
from report.markdown import table
from report.text import bytes_text, hits_text, is_number, machine_text, number_text, seconds_text

HEADS = (
    "scene",
    "triangles",
    "texels by",
    "reference",
    "light map: mean",
    "worst region",
    "RMS",
    "photon map: mean",
    "fit for 10 %: light map",
    "verdict",
)
METHOD_HEADS = ("method", "hits", "mean error", "worst filled region", "RMS", "bytes", "seconds")
CREDIT_HEADS = ("scene", "title", "author", "licence", "source")


def markdown(document):
    records = document["scenes"]
    lines = [
        "# Scenes that others made",
        "",
        *table(HEADS, map(summary_cells, records)),
        "",
        "Mean errors are signed, with their standard error: of the sum over all points that the camera sees, and of each square of 8 x 8 points "
        "that a surface fills. RMS is the relative root mean square error of single points (eps: a hundredth of the squared mean). Errors "
        f"are of the mean of {document['settings']['seeds']} seeds at the largest number of hits, against a path traced reference. Bounds: light map "
        "1 % in the mean and 2 % in every filled region, photon map 2 % in the mean. MISSED: by more than chance explains; "
        "within chance: over the bound, by no more than that.",
        "",
        *dark_lines(document),
        "Pictures: " + WORDS + ".",
        "",
    ]
    for record in records:
        lines += scene_lines(record)
    lines += ["## Whose they are", "", *credit_lines(records), "", "## How this was made", "", *made_lines(document), ""]
    return "\n".join(lines)


def percent(value, digits=2):
    return f"{100 * value:+.{digits}f}" if is_number(value) else "-"


def error_text(values):
    """+0.12 ± 0.05 %"""
    error = error_of(values)
    if error is None:
        return "-"
    chance = f" ± {100 * error.chance:.2f}" if is_number(error.chance) else ""
    return f"{percent(error.value)}{chance}\u00a0%"


def rms_text(value):
    return f"{100 * value:.1f}\u00a0%"


def largest(record, asked):
    rows = [row for row in record["methods"] if row["asked"] == asked and "skipped" not in row]
    return max(rows, key=lambda row: row["hits"], default=None)


def placement_text(record):
    texels = record["info"].get("texels")
    if not texels:
        return "-"
    parts = [f"{texels[f'instances_by_{kind}']} {kind}" for kind in ("uv", "face") if texels.get(f"instances_by_{kind}")]
    return ", ".join(parts) or "-"


def fit_text(record, kind):
    fit = record["fit"]
    entry = fit.get(kind)
    if entry is None:
        return fit.get("reason", "-")
    if not entry["reached"]:
        return f"out of reach: {entry['reason']}"
    choice = entry["choice"]
    unsure = "" if entry.get("sure", True) else ", unsure"
    return (
        f"{choice['method']}, {hits_text(choice['hits'])} hits, {seconds_text(choice['seconds'])}, {bytes_text(choice['bytes'])}, "
        f"{rms_text(choice['error'])} estimated{unsure}"
    )


def summary_cells(record):
    if "failed" in record:
        return [record["name"], *["-"] * (len(HEADS) - 2), f"not measured: {record['failed']}"]
    light_map, photon_map = largest(record, "shlm"), largest(record, "photonmap")
    reference = f"{record['reference']['samples_per_pixel']} samples, {100 * record['reference']['relative_error']:.2g}\u00a0%"
    return [
        record["name"],
        f"{record['info']['triangles']:,}",
        placement_text(record),
        reference,
        error_text(light_map and light_map["mean"]),
        error_text(light_map and light_map["worst_region"]),
        rms_text(light_map["rms"]) if light_map else "-",
        error_text(photon_map and photon_map["mean"]),
        fit_text(record, "light_map").split(",")[0],
        record["verdict"],
    ]


def scene_lines(record):
    lines = [f"## {record['name']}", ""]
    if "failed" in record:
        return [*lines, f"Not measured: {record['failed']}", ""]
    lines += [f"![{record['name']}](images/{record['name']}.png)", ""]
    if record["options"]:
        lines += [f"With {' '.join(record['options'])}.", ""]
    lines += [*table(METHOD_HEADS, map(method_cells, record["methods"])), ""]
    lines += [f"- {bound['text']}: {error_text(bound['error'])}, bound {100 * bound['bound']:g} %: {bound['verdict']}" for bound in record["bounds"]]
    lines += [f"- fit for 10 %, {kind.replace('_', ' ')}: {fit_text(record, kind)}" for kind in ("light_map", "photon_map")]
    lines.append(f"- reference: {reference_text(record)}")
    warnings = list(dict.fromkeys([*record["info"].get("warnings", []), *record["reference"]["warnings"]]))
    lines += [f"- warning: {warning}" for warning in warnings] or ["- no warnings"]
    lines += [f"- {problem}" for problem in record["problems"]]
    return [*lines, ""]


def reference_text(record):
    reference = record["reference"]
    return (
        f"{reference['samples_per_pixel']} samples a point at {record['points']} points, error of single points "
        f"{number_text(100 * reference['relative_error'])} %, {seconds_text(reference['seconds'])}"
    )


def method_cells(row):
    name = row["method"] if row["asked"] != "shlm" else f"{row['method']} (default)"
    if "skipped" in row:
        return [name, hits_text(row["hits"]), f"not measured: {row['skipped']}", *["-"] * 4]
    return [
        name,
        hits_text(row["hits"]),
        error_text(row["mean"]),
        f"{error_text(row['worst_region'])} of {row['regions']}",
        rms_text(row["rms"]),
        bytes_text(row["bytes"]),
        seconds_text(row["seconds"]),
    ]


def dark_lines(document):
    if not document["without_light"]:
        return []
    return [f"Left out, as there is no light in them: {', '.join(document['without_light'])}.", ""]


def credit_lines(records):
    return table(CREDIT_HEADS, [[r["name"], *(r["credit"].get(key, "not said") for key in CREDIT_HEADS[1:])] for r in records])


def made_lines(document):
    context = next((r["context"] for r in document["scenes"] if "context" in r), {})
    settings = document["settings"]
    libraries = ", ".join(f"{name} {version}" for name, version in context.get("libraries", {}).items())
    return [
        f"- machine: {machine_text(context)}, {context.get('threads', '?')} threads",
        f"- flags: {context.get('flags', 'unknown')}",
        f"- versions: {libraries or 'unknown'}",
        f"- date: {document['date']}",
        f"- methods: {settings['methods']}; hits: {settings['hits']}; seeds 1 to {settings['seeds']}; {context.get('settings', '')}",
        f"- reference: 96 x 54 points, seed 1, until {settings['reference_until']} or for {settings['reference_seconds']:g} s",
        f"- fit: target 10 %, seed 1, at most {settings['fit_max_hits']} hits, at most {settings['fit_seconds']:g} s",
    ]
