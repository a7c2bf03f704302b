"""Checks the figures of texts against the data they are from: bench/report figures [--write] FILE.md...

A figure is followed by a marker that names its file and key, which no reader sees:

    0.87 s<!-- =side-by-side/compare.json rows/[scene=cornell,method=shlm,hits_asked=1e6]/build_seconds -->

FILE is relative to the text's folder, or to results/ beside it. A key is a path through the JSON: names, numbers of list elements, [NAME] for a name with
slashes, [NAME=VALUE,...] for the element that has these, * for all. "least" or "most" before it chooses of several: most rows/[method=shlm]/bytes MiB.

A word after it says how the number is to be read: % (times 100), ms, us, ns, M (millions), KiB, MiB, GiB, root% (100 times the root of a mean square),
/PATH (divided by the number at that path of the same file). The printed number must be the data's, rounded to as many digits as it has.

A part of a text between <!-- copy of FILE --> and <!-- end of copy --> must be in FILE word for word.

--write puts the data's numbers in place of stale ones, with as many decimals; copies stay as they are.

Exit code: 0; 1 where a figure is stale; 2 for bad input.
"""

import json
import math
import re
import sys
from functools import lru_cache
from pathlib import Path

NUMBER = r"((?:(?<![\w.)])[-+])?\d[\d,]*(?:\.\d+)?(?:e[+-]?\d+)?)"
MARKER = re.compile(NUMBER + r"([^<>\d]{0,24})<!-- =(\S+) (.+?) -->")  # the last number before it
COPY = re.compile(r"<!-- copy of (\S+) -->\n(.*?)<!-- end of copy -->", re.DOTALL)
UNITS = {"": 1.0, "%": 100.0, "ms": 1e3, "us": 1e6, "ns": 1e9, "M": 1e-6, "KiB": 2.0**-10, "MiB": 2.0**-20, "GiB": 2.0**-30}


class StaleFigure(Exception):
    """One line."""


@lru_cache(maxsize=None)
def data_of(file):
    return json.loads(file.read_text(encoding="utf-8"))


def same(value, text):
    """Whether the text is the value, as a word or as a number."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        try:
            return float(value) == float(text)
        except ValueError:
            return False
    return str(value) == text


def chosen(elements, condition):
    wanted = dict(part.split("=", 1) for part in condition.split(","))
    return [e for e in elements if all(name in e and same(e[name], value) for name, value in wanted.items())]


def steps_of(path):
    """rows/[method=a/b]/[c/d]/x -> rows, [method=a/b], [c/d], x: brackets may hold slashes."""
    return re.findall(r"\[[^\]]*\]|[^/\[\]]+", path)


def one_step(data, step):
    """All that the step leads to."""
    if step == "*":
        return list(data.values()) if isinstance(data, dict) else data
    if step.startswith("[") and "=" in step:
        return chosen(data, step[1:-1])
    if isinstance(data, list):
        return data[int(step) :][:1]
    name = step[1:-1] if step.startswith("[") else step
    return [data[name]] if name in data else []


def values_at(data, path):
    """Of every way that the path leads; a way that ends before is left out."""
    found = [data]
    for step in steps_of(path):
        found = [value for place in found for value in one_step(place, step)]
    if not all(isinstance(value, (int, float)) for value in found):
        raise StaleFigure(f"{path} is no number")
    return found


def in_unit(values, unit, data):
    if unit == "root%":
        return [100 * math.sqrt(value) for value in values]
    if unit.startswith("/"):
        others = values_at(data, unit[1:])
        if len(others) != len(values):
            raise StaleFigure(f"{unit[1:]} is {len(others)} numbers")
        return [value / other for value, other in zip(values, others)]
    return [value * UNITS[unit] for value in values]


CHOICES = {"least": min, "most": max}


def value_of(data, words):
    """Of [least|most] PATH [UNIT]: names in a path may have spaces."""
    choice, _, rest = words.partition(" ")
    choose, words = (CHOICES[choice], rest) if choice in CHOICES else (None, words)
    path, _, unit = words.rpartition(" ")
    if not (unit in UNITS or unit == "root%" or unit.startswith("/")):
        path, unit = words, ""
    values = values_at(data, path)
    if not values or (len(values) > 1 and not choose):
        raise StaleFigure(f"{path} is {len(values)} numbers")
    return (choose or min)(in_unit(values, unit, data))


def half_of_last_digit(text):
    """9.5 -> 0.05, 1.2e3 -> 50; of whole numbers the trailing zeros may be rounding: 27,300 -> 50"""
    mantissa, _, exponent = text.partition("e")
    if "." in mantissa:
        digits = -len(mantissa.split(".")[1])
    else:
        digits = len(mantissa) - len(mantissa.rstrip("0")) if mantissa.strip("0") else 0
    return 0.5 * 10.0 ** (digits + int(exponent or 0))


def is_printed(text_number, value):
    """Whether the text is the value, as far as its digits go."""
    number = text_number.replace(",", "")
    return abs(float(number) - value) <= half_of_last_digit(number) * (1 + 1e-9)


def check(text_number, value):
    if not is_printed(text_number, value):
        raise StaleFigure(f"{text_number} is {value:.6g} by its data")


def printed(value, like):
    """The value with as many digits after the point as `like` has, or rounded where that has zeros at its end."""
    number = like.replace(",", "")
    if "e" in number:
        return f"{value:.{len(number.partition('e')[0].partition('.')[2])}e}".replace("e+0", "e").replace("e-0", "e-")
    if "." in number:
        return f"{value:.{len(number.partition('.')[2])}f}"
    step = 2 * half_of_last_digit(number)
    return f"{round(value / step) * step:{',' if ',' in like else ''}.0f}"


def data_file(text_file, name):
    beside = [text_file.parent / name, text_file.parent / "results" / name]
    for file in beside:
        if file.exists():
            return file
    raise StaleFigure(f"{name} is not there")


def stale_in(text_file):
    """What is stale, a line each."""
    text = text_file.read_text(encoding="utf-8")
    problems = []

    def attempt(place, what):
        try:
            what()
        except (StaleFigure, ValueError, IndexError, KeyError) as error:
            problems.append(f"{text_file}:{text.count(chr(10), 0, place) + 1}: {error}")

    for found in MARKER.finditer(text):
        number, _, name, words = found.groups()
        attempt(found.start(), lambda: check(number, value_of(data_of(data_file(text_file, name)), words)))
    for found in COPY.finditer(text):
        name, part = found.groups()

        def is_copied():
            if part.strip() not in data_file(text_file, name).read_text(encoding="utf-8"):
                raise StaleFigure(f"this is not what {name} says")

        attempt(found.start(), is_copied)
    return problems, len(MARKER.findall(text)), len(COPY.findall(text))


def write_anew(text_file):
    """Every figure whose data is there; what is wrong with the others is for stale_in to say."""

    def mended(found):
        number, _, name, words = found.groups()
        try:
            value = value_of(data_of(data_file(text_file, name)), words)
        except (StaleFigure, ValueError, IndexError, KeyError):
            return found[0]
        return (number if is_printed(number, value) else printed(value, number)) + found[0][len(number) :]

    text_file.write_text(MARKER.sub(mended, text_file.read_text(encoding="utf-8")), encoding="utf-8")


def main(arguments):
    stale = False
    writes = arguments[:1] == ["--write"]
    for name in arguments[writes:]:
        try:
            if writes:
                write_anew(Path(name))
            problems, figures, copies = stale_in(Path(name))
        except OSError as error:
            print(f"bench/report figures: {error}", file=sys.stderr)
            return 2
        for problem in problems:
            print(problem, file=sys.stderr)
        stale |= bool(problems)
        print(f"{name}: {figures} figures and {copies} copies, {len(problems)} stale")
    return 1 if stale else 0
