"""One page of all results, to be opened by double click: bench/report page OUT.html FOLDER...

FOLDER: results, or folders of results; each folder in them counts as well. Style, script, data and charts are in the page; pictures, reports and data
stay beside it and are linked. Prints the answer in five lines and the page's place.
"""

import os
import sys
from pathlib import Path

from report.page import answer, bases, chooser, claims, elsewhere, fits, history, lit, measured, panels, pictures, stability
from report.page.charts import Charts
from report.page.find import find
from report.page.markup import Markup, joined, script_json, tag
from report.page.rows import StudyRows
from report.page.words import MISSING
from report.study.data import StudyError

HERE = Path(__file__).resolve().parent
SCRIPT = ("tools", "state", "runs", "charts", "one_run", "filters", "chooser", "pictures", "main")  # in this order
NO_CLAIMS = MISSING.format("/usr/bin/python3 bench/report verdicts results/verdicts.md FOLDER...")
NO_STUDY = MISSING.format("./reproduce, or ./reproduce --full for all methods,")


def sections(results, study, charts):
    """(id, title, content), from top to bottom."""
    return (
        ("claims", "Does the paper hold?", claims.section(results) if results.verdicts else tag("p", NO_CLAIMS)),
        ("choose", "Which map for my error?", chooser.section(study) if study else tag("p", NO_STUDY)),
        ("charts", "Error, time and memory", panels.section(charts) if charts else tag("p", NO_STUDY)),
        ("pictures", "What it looks like", pictures.section(results, study)),
        ("lit", "Lit in a browser", lit.section(results)),
        ("stability", "Where the methods fail", stability.section(results)),
        ("elsewhere", "On scenes that others made", elsewhere.section(results)),
        ("fits", "What each scene needs", joined([fits.section(results), bases.section(results)])),
        ("history", "What changes did to speed and accuracy", history.section(results)),
        ("measured", "How it was measured", measured.section(results)),
    )


def filled(template, parts):
    """{{name}} in the template by its part. Parts are not searched again."""
    pieces = []
    for number, piece in enumerate(template.replace("{{", "}}").split("}}")):
        pieces.append(parts[piece] if number % 2 else piece)
    return "".join(pieces)


def section_markup(identity, title, content):
    return tag("section", tag("h2", title), content, id=identity)


def script():
    """One function that runs at once, so that no name of its parts is seen from outside."""
    parts = [(HERE / "script" / f"{name}.js").read_text(encoding="utf-8") for name in SCRIPT]
    return "\n".join(["(() => {", '"use strict";', *parts, "})();"])


def page(results):
    """(HTML, the five lines)"""
    study = StudyRows(results.study) if results.study else None
    charts = Charts(study) if study and study.rows else None
    lines = answer.lines(results, study if charts else None)
    made = sections(results, study if charts else None, charts)
    data = {"charts": panels.data(charts), "chooser": chooser.data(study)} if charts else {}
    parts = {
        "style": (HERE / "page.css").read_text(encoding="utf-8"),
        "script": script(),
        "answer": tag("ol", *(tag("li", line) for line in lines), cls="answer"),
        "contents": joined(tag("a", title, href=f"#{identity}") for identity, title, _ in made),
        "shared": charts.shared() if charts else "",
        "sections": joined((section_markup(*one) for one in made), "\n"),
        "data": script_json(data),
    }
    return Markup(filled((HERE / "page.html").read_text(encoding="utf-8"), parts)), lines


def write_whole(path, text):
    """All of it or nothing."""
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(text, encoding="utf-8")
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def main(arguments):
    out = Path(arguments[0])
    try:
        results = find(out, arguments[1:])
        if results.is_empty:
            raise StudyError(f"no results in {', '.join(arguments[1:])}")
        text, lines = page(results)
        write_whole(out, text)
    except KeyError as error:
        print(f"bench/report page: results without {error}", file=sys.stderr)
        return 2
    except (StudyError, OSError, ValueError, TypeError) as error:
        print(f"bench/report page: {error}", file=sys.stderr)
        return 2
    print("\n".join([*lines, "", str(out)]))
    return 0
