"""The tables of the report, in Markdown."""

from report.markdown import table
from report.study.data import PHASES
from report.study.methods import REFERENCE_PHOTON_MAP
from report.study.targets import AT_FIRST, BEYOND, NEVER, TARGETS, may_be_as_good, winners
from report.text import NOTHING, band_text, bytes_text, hits_text, number_text, percent_text, seconds_text


def reach_text(reach, unit_text, is_best, is_as_good):
    if reach.kind == NEVER:
        return "never"
    if reach.kind == BEYOND:
        return f"beyond {hits_text(reach.largest_hits)}"
    text = ("< " if reach.kind == AT_FIRST else "") + unit_text(reach.cost)
    return f"**{text}**" if is_best else f"*{text}*" if is_as_good else text


def reach_table(reaches_by_target, unit_text):
    """`reaches_by_target`: target -> method -> Reach. Bold: winners; italic: bands reach theirs."""
    names = list(reaches_by_target[TARGETS[0]])
    first = {target: winners(reaches) for target, reaches in reaches_by_target.items()}
    as_good = {target: may_be_as_good(reaches) for target, reaches in reaches_by_target.items()}
    rows = [
        [name]
        + [
            reach_text(reaches_by_target[t][name], unit_text, name in first[t], name in as_good[t])
            for t in TARGETS
        ]
        for name in names
    ]
    return table(["method"] + [f"{100 * t:g} % RMS" for t in TARGETS], rows)


def slope_text(slope):
    return NOTHING if slope is None else band_text(slope.value, slope.band, 3)


def slope_table(findings):
    """`findings`: name -> SlopeFinding"""
    rows = [
        [
            name,
            str(f.error.sizes) if f.error else NOTHING,
            slope_text(f.error),
            slope_text(f.variance),
            f.theory_text,
            f.verdict,
        ]
        for name, f in findings.items()
    ]
    return table(
        ["method", "sizes fitted", "slope of the error", "slope of the variance", "theory", "verdict"], rows
    )


def point_row(point, label):
    run, split = point.run, point.split
    times = [seconds_text(run.median(phase + "_seconds")) for phase in PHASES]
    flip = number_text(run.flip)
    prepared = [
        text(run.median(column)) if run.has(column) else NOTHING
        for column, text in (("prepare_seconds", seconds_text), ("prepare_bytes", bytes_text), ("insert_bytes", bytes_text))
    ]
    return [
        label,
        hits_text(point.hits),
        str(split.seed_count),
        percent_text(split.error),
        band_text(split.error, split.error_band),
        band_text(split.bias_sq, split.bias_sq_band),
        band_text(split.variance, split.variance_band),
        flip,
        *times,
        seconds_text(point.seconds),
        bytes_text(point.bytes),
        *prepared,
    ]


def full_table(curves, skipped):
    """`skipped`: (method, hits asked for, reason)"""
    header = [
        "method",
        "hits",
        "seeds",
        "RMS",
        "error [band]",
        "bias² [band]",
        "variance [band]",
        "FLIP",
        *PHASES,
        "total",
        "bytes",
        "prepare, once a scene",
        "prepared bytes",
        "bytes while filled",
    ]
    names = list(dict.fromkeys([*curves, *(method for method, _, _ in skipped)]))
    rows = []
    for name in names:
        rows += [point_row(point, name) for point in (curves[name].points if name in curves else ())]
        rows += [
            [name, hits_text(hits), f"skipped: {why}", *[""] * (len(header) - 3)]
            for method, hits, why in skipped
            if method == name
        ]
    return table(header, rows)


def less_text(less, unit_text, density_text=lambda x: ""):
    """from 2 M [1.8 M, 2.3 M] / up to 2 M / 1 M to 5 M / always / never, all on the range measured."""
    if less.range is None:
        return "not comparable"
    if less.always:
        return f"always ({unit_text(less.range[0])} to {unit_text(less.range[1])})"
    if less.never:
        return f"never ({unit_text(less.range[0])} to {unit_text(less.range[1])})"

    band = f" [{unit_text(less.band[0])}, {unit_text(less.band[1])}]" if less.band else ""
    return intervals_text(less, unit_text, lambda end: f"{density_text(end)}{band}")


def intervals_text(less, unit_text, after_end=lambda end: ""):
    """`after_end`: what stands behind the only end of an open interval."""

    def part(low, high):
        if high is None:
            return f"from {unit_text(low)}{after_end(low)}"
        return f"up to {unit_text(high)}{after_end(high)}" if low is None else f"{unit_text(low)} to {unit_text(high)}"

    return ", ".join(part(low, high) for low, high in less.intervals)


def where_text(less):
    """As less_text, without bands and ranges: from 2 M, up to 2 M, 1 M to 5 M, always, never."""
    if less.range is None:
        return NOTHING
    if less.always or less.never:
        return "always" if less.always else "never"
    return intervals_text(less, hits_text)


def crossing_overview(findings):
    """`findings`: scene -> SceneFindings. At equal hits, all scenes side by side."""
    names = list(dict.fromkeys(name for found in findings.values() for name in found.crossings))
    rows = [
        [name, *(where_text(found.crossings[name].hits) if name in found.crossings else NOTHING for found in findings.values())] for name in names
    ]
    return table(["hits", *findings], rows) if rows else []


def density_text_of(texels):
    return lambda hits: f" ({number_text(hits / texels, 2)}/texel)" if texels else ""


def crossing_table(found):
    """`found`: SceneFindings; no lines where there is nothing to compare."""
    if not found.crossings:
        return []
    density = density_text_of(found.texels)
    rows = [
        [
            name,
            less_text(c.hits, hits_text, density),
            less_text(c.seconds, seconds_text),
            less_text(c.bytes, hits_text, density),
        ]
        for name, c in found.crossings.items()
    ]
    lines = table(
        [
            "photon map",
            "at equal hits: hits",
            "at equal time: total time",
            "at equal bytes: hits of the light map",
        ],
        rows,
    )
    if found.smaller:
        lines = [
            f"Smaller than {REFERENCE_PHOTON_MAP} at equal hits: "
            f"{less_text(found.smaller, hits_text, density)}.",
            "",
            *lines,
        ]
    return lines


def front_text(front):
    """method at 1 M, 10 M; in ascending order of cost, neighbours of one method together"""
    parts = []
    for point in front:
        entry = f"{hits_text(point.hits)} ({percent_text(point.split.error)})"
        if parts and parts[-1][0] == point.run.method:
            parts[-1][1].append(entry)
        else:
            parts.append((point.run.method, [entry]))
    return "; ".join(f"{name} at {', '.join(entries)}" for name, entries in parts)


def front_table(findings):
    """`findings`: scene -> SceneFindings"""
    rows = [
        [scene, front_text(f.front_by_time), front_text(f.front_by_bytes)] for scene, f in findings.items()
    ]
    return table(["scene", "by total time", "by bytes of the finished map"], rows)
