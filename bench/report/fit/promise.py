"""Whether fit keeps its word on scenes that nobody chose: random rooms, fitted and then measured with other seeds.

    bench/report fit-promise SHLMBENCH SHLMBENCH_SCENES OUT --rooms 201,24 [--targets 20%,10%,5%] ...

Makes OUT/promise.json, promise.md and promise.png. Rooms 1 to 24 are those that margins were taken from, 201 to 224 those that they are
tested on. Stopped, it goes on from the last finished room in --work. Exit code: 0; 1 where less than nine of ten runs meet a target of
which fit was sure; 2 for bad input; 130 if stopped.
"""

import argparse
import json
import sys
from pathlib import Path

from report.fit.promise_chart import draw
from report.fit.promise_rows import rows_of, summary_of, table_of
from report.fit.promise_run import PromiseError, Settings, all_fits

WANTED = 0.9


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="bench/report fit-promise", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="SHLMBENCH")
    parser.add_argument("maker", metavar="SHLMBENCH_SCENES")
    parser.add_argument("out", metavar="OUT", type=Path)
    parser.add_argument("--rooms", required=True, metavar="FIRST,COUNT")
    parser.add_argument("--work", type=Path, help="for scenes, references and fits; OUT/work if nothing is said")
    parser.add_argument("--targets", default="20%,10%,5%")
    parser.add_argument("--max-hits", default="3e7")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--reference-until", default="4%")
    parser.add_argument("--time", default="")
    return parser.parse_args(arguments)


def rooms_of(text):
    try:
        first, count = (int(number) for number in text.split(","))
    except ValueError:
        raise PromiseError(f"--rooms: '{text}' is not FIRST,COUNT") from None
    if first < 0 or count < 1:
        raise PromiseError(f"--rooms: '{text}' has no rooms")
    return first, count


def main(arguments):
    given = parsed(arguments)
    settings = Settings(given.program, given.maker, given.targets, given.max_hits, given.seeds, given.reference_until, given.time)
    try:
        first, count = rooms_of(given.rooms)
        given.out.mkdir(parents=True, exist_ok=True)
        fits = list(all_fits(first, count, settings, given.work or given.out / "work"))
    except (PromiseError, OSError) as error:
        print(f"bench/report fit-promise: {error}", file=sys.stderr)
        return 2
    rows = rows_of(fits)
    summary = summary_of(rows)
    rooms = {"first": first, "count": count}
    document = {"context": fits[0]["context"], "rooms": rooms, "settings": vars(settings) | {"program": "shlmbench", "maker": "shlmbench_scenes"}}
    document |= {"summary": summary, "rows": rows}
    (given.out / "promise.json").write_text(json.dumps(document, indent=1) + "\n")
    (given.out / "promise.md").write_text(table_of(document))
    draw(document, given.out / "promise.png")
    print(table_of(document), end="")
    sure = summary["sure"]
    return 0 if sure["runs"] == 0 or sure["runs_that_meet"] >= WANTED * sure["runs"] else 1
