"""What a texel keeps and what that loses where normals are bent: bases by their bytes, an error for each kind of light."""

from report.page.markup import joined, table, tag
from report.page.quantities import percent_text
from report.page.words import MISSING, origin_text

MISSING_TEXT = MISSING.format("build/release/shlmbench bases --out results/bases")

SHOWN = ("mixed room", "coloured room")  # lights that are like rooms, for the sentence


def by_basis(rows):
    """basis -> light -> row, the fewest bytes first"""
    found = {}
    for row in sorted(rows, key=lambda r: r["bytes_per_texel"]):
        found.setdefault(row["basis"], {})[row["light"]] = row
    return found


def finding(rows, light):
    """The smallest texel whose mean error is at most a tenth in this light."""
    within = [r for r in rows if r["light"] == light and r["mean"] <= 10]
    if not within:
        return f"No basis stays within 10 % in a {light}."
    least = min(within, key=lambda r: (r["bytes_per_texel"], r["mean"]))
    return f"In a {light} the smallest texel within 10 % is {least['basis']}, {least['bytes_per_texel']} bytes: {percent_text(least['mean'])}."


def part(source):
    rows, lights = source.document["rows"], list(source.document["lights"])
    lines = []
    for basis, found in by_basis(rows).items():
        any_row = next(iter(found.values()))
        cells = [f"{found[light]['mean']:.1f} (worst {found[light]['worst']:.0f})" if light in found else "-" for light in lights]
        lines.append((tag("code", basis), any_row["numbers_per_texel"], any_row["bytes_per_texel"], *cells))
    return joined(
        [
            tag("p", " ".join(finding(rows, light) for light in lights if light in SHOWN) or finding(rows, lights[0]), cls="finding"),
            table(("basis", "numbers", "bytes a texel", *(f"{light}, error %" for light in lights)), lines),
            tag("p", f"Mean and worst over normals bent by up to 60 degrees, without noise. {origin_text(source.context)}.", cls="origin"),
        ]
    )


def section(results):
    head = tag("h3", "What a texel should keep")
    return joined([head, *map(part, results.bases)]) if results.bases else joined([head, tag("p", MISSING_TEXT)])
