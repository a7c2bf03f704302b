"""Scenes that others made: where bounds are kept that were not set on them."""

from report.elsewhere.figures import MISSED, PASSED
from report.elsewhere.text import HEADS, summary_cells
from report.page.markup import joined, link, table, tag
from report.page.words import MISSING, origin_text, plural

MISSING_TEXT = MISSING.format("./reproduce --elsewhere FOLDER")
BOUNDS = (
    "Mean errors are signed: too bright is positive. Bounds: the light map 1 % in the mean and 2 % in every filled region of 8 x 8 points, the photon "
    "map 2 % in the mean. MISSED: by more than chance explains."
)


def finding_words(records):
    verdicts = [record.get("verdict") for record in records]
    within, missed = verdicts.count(PASSED), verdicts.count(MISSED)
    others = len(verdicts) - within - missed
    words = f"Of {plural(len(records), 'scene')} that others made, within all bounds: {within}; outside one: {missed}"
    return f"{words}; left open by chance or not measured: {others}." if others else f"{words}."


def row(results, source, record):
    """The scene's name leads to its picture."""
    name, *cells = summary_cells(record)
    picture = source.folder / "images" / f"{name}.png"
    return [link(results.link(picture), name) if picture.is_file() else name, *cells]


def part(results, source):
    records = source.document["scenes"]
    context = next((record["context"] for record in records if "context" in record), None)
    return joined(
        [
            tag("p", finding_words(records), cls="finding"),
            table(HEADS, [row(results, source, record) for record in records], cls="wrap"),
            tag("p", BOUNDS),
            tag("p", link(results.link(source.folder / "report.md"), "every method, picture and credit")),
            tag("p", f"{origin_text(context)}.", cls="origin") if context else None,
        ]
    )


def section(results):
    return joined(part(results, source) for source in results.elsewhere) if results.elsewhere else tag("p", MISSING_TEXT)
