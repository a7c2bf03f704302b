"""Lit in a browser: what fragment programs answer and cost, with the scenes to walk in."""

from report import realtime
from report.claims.realtime_claims import LIGHT_MAP, TRADITIONAL, at_most_hits
from report.page.markup import joined, link, table, tag
from report.page.words import MISSING, origin_text
from report.text import number_text

MISSING_TEXT = MISSING.format("./reproduce --realtime")
NAMES = "viewer-*.html"  # beside realtime.json: pages that light a scene


def finding_words(document):
    """Light map beside traditional map, by scene, as the graphics card filters."""
    rows, words = at_most_hits(document), []
    for entry in document["scenes"]:
        errors = [realtime.median([r for r in rows if r["method"].startswith(name)], "error", scene=entry["scene"], filter="hardware") for name in (LIGHT_MAP, TRADITIONAL)]
        if all(errors):
            words.append(f"{entry['scene']} {number_text(100 * errors[0])} % beside {number_text(100 * errors[1])} %")
    return f"Error of order 2 beside a traditional light map, with every normal map: {'; '.join(words)}." if words else "No reference says how large the errors are."


def part(results, source):
    document = source.document
    rows = at_most_hits(document)
    methods = list(dict.fromkeys(row["method"] for row in rows))
    scenes = [entry["scene"] for entry in document["scenes"]]
    viewers = [link(results.link(file), file.stem.removeprefix("viewer-")) for file in sorted(source.folder.glob(NAMES))]
    return joined(
        [
            tag("p", finding_words(document), cls="finding"),
            tag("p", "Walk in them, bend their normals: ", joined(viewers, ", "), ".") if viewers else None,
            table(realtime.HEADS, [realtime.cells_of(rows, scene, method) for scene in scenes for method in methods], cls="wrap"),
            table(realtime.COST_HEADS, [realtime.cost_cells(rows, method) for method in methods]),
            tag("p", "Differences are relative RMS beside the program's own answers, errors are against the reference. Drawn by ", rows[0]["renderer"], ", whose times are not published."),
            tag("p", f"{origin_text(source.context)}.", cls="origin"),
        ]
    )


def section(results):
    return joined(part(results, source) for source in results.realtime) if results.realtime else tag("p", MISSING_TEXT)
