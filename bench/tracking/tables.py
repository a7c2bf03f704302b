"""A record as text."""

import math

import history
from interval import CONFIDENCE
from render_errors import HITS, SEEDS

TIMES = ("benchmark", "BASE s", "HEAD s", "ratio", "interval", "band", "instructions", "verdict")
ERRORS = ("relative RMS error", "BASE", "HEAD", "ratio", "interval", "verdict")


def aligned(rows):
    """First column to the left, the others to the right."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return ["  ".join([row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:]))]) for row in rows]


def figures(row):
    low, high = row["interval"]
    return f"{row['base']:.4g}", f"{row['head']:.4g}", f"{row['ratio']:.4f}", f"{low:.4f} .. {high:.4f}"


def band_text(row):
    return "" if row["band"] is None else f"{math.expm1(row['band']):.2%}"


def instructions_text(row):
    base, head = row.get("instructions", (None, None))
    return f"{head / base:.4f}" if base and head else ""


def failed_row(name, row, columns):
    return (name, *[""] * (columns - 2), row["because"])


def time_rows(rows):
    for name, row in rows.items():
        if "ratio" in row:
            yield (name, *figures(row), band_text(row), instructions_text(row), row["verdict"])
        else:
            yield failed_row(name, row, len(TIMES))


def error_rows(rows):
    for name, row in rows.items():
        yield (name, *figures(row), row["verdict"]) if "ratio" in row else failed_row(name, row, len(ERRORS))


def text_of(record):
    lines = [f"{record['base']} -> {record['head']} ({record['kind']}), {record['pairs']} pairs; ratios are HEAD / BASE"]
    lines.append(f"intervals: {CONFIDENCE:.0%} for all rows of a table together; instructions: HEAD / BASE, one iteration")
    lines += ["", *aligned([TIMES, *time_rows(record["benchmarks"])])]
    if record["errors"]:
        lines += ["", f"{HITS} hits, {len(SEEDS)} seeds, scenes of HEAD, references in results/references"]
        lines += aligned([ERRORS, *error_rows(record["errors"])])
    for which in ("base", "head"):
        if missing := record["missing"][which]:
            lines += ["", f"not in {which.upper()}: {', '.join(missing)}"]
    if record["scenes_differ"]:
        lines += ["", f"the revisions make different scenes: {', '.join(record['scenes_differ'])}; times are of different work"]
    if record["kind"] == history.SAME:
        lines += ["", "one build against its copy: what differs is noise, and widens the bands"]
    if not record["finished"]:
        lines += ["", "interrupted: only what was finished"]
    return "\n".join(lines)
