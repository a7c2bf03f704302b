"""What was measured on this machine, a JSON line for each comparison: results/history/MACHINE.jsonl."""

import json
import math

from input_error import InputError

SAME = "same build twice"  # kind of a comparison that teaches the noise; the other kind:
TWO = "two revisions"


def history_file(repository, machine):
    return repository / "results" / "history" / (machine["name"] + ".jsonl")


def read(file, machine):
    """Throws InputError where a line is none, or another machine's: nothing is compared across machines."""
    if not file.exists():
        return []
    records = []
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        try:
            record = json.loads(line)
            its_machine = record["machine"]["name"]
        except (ValueError, KeyError, TypeError):
            raise InputError(f"{file}, line {number}: not a comparison") from None
        if its_machine != machine["name"]:
            raise InputError(
                f"{file}, line {number}: measured on {its_machine}, this machine is {machine['name']}: they are not compared"
            )
        records.append(record)
    return records


def append(file, record):
    """One write, so that an interruption leaves no half of a line. What failed may name files: below the repository, and not
    where it lies on this machine."""
    file.parent.mkdir(parents=True, exist_ok=True)
    repository = json.dumps(f"{file.parents[2]}/")[1:-1]  # results/history/MACHINE.jsonl, as history_file() has it
    with file.open("a", encoding="utf-8") as out:
        out.write(json.dumps(record).replace(repository, "") + "\n")


def noise_bands(records):
    """By benchmark, in the logarithm: the largest difference that the same build has shown between its two copies.

    Pairs within one run do not show it all: the interval of a run knows nothing of what stays the same during the run.
    """
    bands = {}
    for record in records:
        if record["kind"] != SAME:
            continue
        for name, row in record["benchmarks"].items():
            if "ratio" in row:
                bands[name] = max(bands.get(name, 0.0), abs(math.log(row["ratio"])))
    return bands


def other_machines(file):
    """Names of those whose files lie beside this machine's."""
    return sorted(other.stem for other in file.parent.glob("*.jsonl") if other != file)
