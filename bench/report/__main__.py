"""Reports, charts and tables of what shlmbench has measured: python3 bench/report NAME ARGUMENTS"""

import importlib
import sys
from pathlib import Path

REPORTS = {  # module, arguments, what it makes
    "compare": ("report.compare.charts", "FOLDER", "charts of FOLDER/compare.json"),
    "claims": ("report.claims.report", "FOLDER [STUDY]", "report.md: the paper's claims held against FOLDER/compare.json and STUDY/summary.json"),
    "verdicts": ("report.claims.verdicts", "OUT.md FOLDER...", "one table of verdicts from comparisons and studies"),
    "study": ("report.study.report", "FOLDER", "report.md, charts, pictures and summary.json of FOLDER/study.json"),
    "explanation": ("report.fit.explanation_chart", "FOLDER", "explanation.png of a fit's FOLDER/explanation.json"),
    "fit-search": ("report.fit.search", "STUDY FIT.json...", "fits beside the best that a search found"),
    "fit-promise": ("report.fit.promise", "SHLMBENCH SHLMBENCH_SCENES OUT...", "whether fit keeps its word on random rooms; --help says the rest"),
    "fit-verdict": ("report.fit.verdict", "FIT.json...", "whether each fit meets its target when it is verified"),
    "model-bytes": ("report.fit.model_bytes", "STUDY OUT", "the smallest map for each error"),
    "lighter": ("report.lighter", "OUT", "lighter.md: bases, direct light apart and emission by a sequence, of the studies in OUT"),
    "bases": ("report.bases_charts", "FOLDER", "charts of FOLDER/bases.json"),
    "stability": ("report.stability_charts", "FOLDER", "charts of FOLDER/stability.json"),
    "billion-figure": ("report.claims.billion_figure", "FOLDER", "figure.png: the atrium at a billion hits"),
    "figures": ("report.figures", "[--write] TEXT.md...", "whether the figures of texts are those of their data; --write puts these in"),
    "page": ("report.page.page", "OUT.html FOLDER...", "one page of all results, to be opened by double click"),
    "realtime": ("report.realtime", "PROGRAM...", "what a browser's fragment programs answer, and what they cost; --help says the rest"),
    "elsewhere": ("report.elsewhere.report", "PROGRAM...", "the methods on scenes that others made; --help says the rest"),
}


def usage():
    names = (f"  {name} {arguments}\n      {what}" for name, (_, arguments, what) in REPORTS.items())
    return "\n".join([__doc__, "", *names])


def takes(words, arguments):
    """Whether so many are expected: [OPTIONAL] may be left out, the last may be given several times."""
    expected = words.split()
    least = sum(not word.startswith("[") for word in expected)
    return least <= len(arguments) and (len(arguments) <= len(expected) or words.endswith("..."))


def main(arguments):
    """The exit code."""
    if arguments in (["--help"], ["-h"]):
        print(usage())
        return 0
    if not arguments or arguments[0] not in REPORTS:
        print(f"bench/report: one of {', '.join(REPORTS)} is expected", file=sys.stderr)
        return 2
    name, *rest = arguments
    module, words, _ = REPORTS[name]
    if not takes(words, rest):
        print(f"usage: bench/report {name} {words}", file=sys.stderr)
        return 2
    return importlib.import_module(module).main(rest) or 0


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    sys.path[0] = str(Path(__file__).resolve().parent.parent)
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
