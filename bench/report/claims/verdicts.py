"""One table of verdicts on the paper's claims from all results there are: bench/report verdicts OUT.md FOLDER...

Each FOLDER has a compare.json, a study's summary.json or a realtime.json. Figures of different machines are not joined: each folder is judged by itself, and
a claim's row says what each of them found. Writes OUT.md and OUT.json.
"""

import json
import os
import sys
from dataclasses import asdict
from pathlib import Path

from report.claims.claims import measured_by_study, measured_here
from report.claims.finding import NOT_DECIDED, NOT_MEASURED_YET, PLAIN
from report.claims.judging import RUNS, RUNS_OF_LARGE
from report.claims.realtime_claims import LIGHT_MAP as REALTIME_MAP
from report.claims.realtime_claims import measured_by_fragments
from report.compare.comparison import LIGHT_MAP, Comparison
from report.markdown import table_text
from report.text import machine_text


class Source:
    """A folder's findings, those that it can measure."""

    def __init__(self, folder, context, light_map, findings):
        self.folder, self.context, self.light_map = Path(folder), context, light_map
        self.findings = {f.claim: f for f in findings if f.verdict != NOT_MEASURED_YET}


def read_summary(folder):
    file = Path(folder) / "summary.json"
    return json.loads(file.read_text(encoding="utf-8")) if file.exists() else None


def sources_of(folders):
    studies = [(folder, summary) for folder in folders if (summary := read_summary(folder))]
    study = studies[0][1] if studies else None
    made = []
    for folder in folders:
        if (Path(folder) / "compare.json").exists():
            comparison = Comparison(folder)
            made.append(Source(folder, comparison.context, comparison.light_map, measured_here(comparison, study)))
    for folder in folders:
        if (file := Path(folder) / "realtime.json").exists():
            document = json.loads(file.read_text(encoding="utf-8"))
            made.append(Source(folder, document["context"], REALTIME_MAP, measured_by_fragments(document)))
    made += [Source(folder, summary["context"], LIGHT_MAP, measured_by_study(summary, LIGHT_MAP)) for folder, summary in studies]
    return made


def overall(verdicts):
    decided = {verdict for verdict in verdicts if verdict != NOT_DECIDED}
    if not decided:
        return NOT_DECIDED
    return decided.pop() if len(decided) == 1 else "conditional"


def runs_text(runs):
    if not runs:
        return "runs not said"
    low, high = runs
    return f"{low} runs" if low == high else f"{low} to {high} runs"


def rests_on(source, finding):
    machine = source.context.get("machine", "unknown machine")
    count = len(finding.scenes)
    return f"{source.folder.name}: {count} scene{'s' * (count != 1)} ({', '.join(finding.scenes)}), {runs_text(finding.runs)}, {source.light_map}, {machine}"


def conditions(found, leader):
    """In plain words: of the folder that the figure is of, and whose verdict is another."""
    texts = [finding.plain for source, finding in found if source is leader]
    verdict = overall([f.verdict for _, f in found])
    texts += [f"In {source.folder.name}: {PLAIN.get(f.verdict, f.verdict)}." for source, f in found if f.verdict != verdict]
    return " ".join(filter(None, texts))


def rows_of(sources, out):
    claims = list(dict.fromkeys(claim for source in sources for claim in source.findings))
    rows = []
    for claim in claims:
        found = [(source, source.findings[claim]) for source in sources if claim in source.findings]
        # The figure is of the folder with the most scenes among those that decided anything.
        best, finding = max(found, key=lambda pair: (pair[1].verdict != NOT_DECIDED, len(pair[1].scenes)))
        link = Path(os.path.relpath(best.folder, out.parent)) / "report.md"
        rows.append(
            {
                "claim": claim,
                "says": finding.says,
                "verdict": overall([f.verdict for _, f in found]),
                "condition": conditions(found, best),
                "figure": finding.figure,
                "rests_on": [rests_on(source, f) for source, f in found],
                "link": link.as_posix(),
                "findings": {source.folder.name: asdict(f) for source, f in found},
            }
        )
    return rows


def table(rows):
    heads = ("claim", "the paper says", "verdict", "condition", "figure", "rests on")
    cells = [
        (f"[{row['claim']}]({row['link']})", row["says"], f"**{row['verdict']}**", row["condition"], row["figure"], "; ".join(row["rests_on"]))
        for row in rows
    ]
    return table_text(heads, cells)


WORDS = (
    f"A size counts where every scene of a folder has it with at least {RUNS} repetitions, {RUNS_OF_LARGE} from 1e8 hits on. Ranges over the "
    "repetitions that touch decide nothing. Ratios are the photon map's figure over the light map's; the strongest engine is the one whose "
    "figure is least, among gathers of those whose error is no greater than that of k50/disc. Claims link to the report with all figures."
)


def main(arguments):
    out = Path(arguments[0])
    try:
        sources = sources_of(arguments[1:])
    except (OSError, ValueError, KeyError) as error:
        print(f"bench/report verdicts: {error}", file=sys.stderr)
        return 2
    if not sources:
        print("bench/report verdicts: no folder has a compare.json or a summary.json", file=sys.stderr)
        return 2
    rows = rows_of(sources, out)
    made = "\n".join(f"- {source.folder.name}: {machine_text(source.context)}" for source in sources)
    out.write_text(f"# Verdicts on the paper's claims\n\n{table(rows)}\n{WORDS}\n\n{made}\n", encoding="utf-8")
    out.with_suffix(".json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    width = max(len(row["claim"]) for row in rows)
    for row in rows:
        print(f"{row['claim']:<{width}}  {row['verdict']:<12}  {row['figure']}  {row['condition']}")
    return 0
