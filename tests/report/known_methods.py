"""What the rows of results say of a method, from methods.json: `shlmbench methods --json NAME ...` wrote it, and a test holds it to that."""

import json
from pathlib import Path

FILE = Path(__file__).resolve().parent / "methods.json"
KNOWN = {entry["method"]: entry for entry in json.loads(FILE.read_text(encoding="utf-8"))["methods"]}


def facts_of(name):
    """"method", "fields" and "style"; of a method that nobody knows its name alone."""
    if name not in KNOWN:
        return {"method": name}
    return {key: KNOWN[name][key] for key in ("method", "fields", "style")}
