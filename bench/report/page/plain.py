"""A claim's condition in a few plain words, from the findings of verdicts.json; their long text stands behind it.

The findings' conditions are sentences of report.claims: SAYINGS knows those of judging.py. What it does not know is left to the long text.
"""

import re

SIDES = {"flann-incremental": "a tree that takes photons one by one", "the strongest engine": "today's strongest photon map"}
SIDE = re.compile(r"(flann-incremental|the strongest engine): ([a-z ]+?)(?: \(([^()]*)\))?(?=; |$)")
SMALLER = re.compile(r"the strongest engine is the smaller map below ([\d. to]+ [kMG]) hits")
SAYINGS = (
    (re.compile(r"true in every scene from (\S+ [kMG]|\S+) hits on"), "from {} hits on"),
    (re.compile(r"false in every scene at ([^;()]+?)(?:;|$)"), "fails at {} hits"),
    (re.compile(r"true in some scenes or at some sizes only"), "in some scenes or at some sizes only"),
)
LACKING = re.compile(r"not judged at ([\d.]+ ?[kMG]?)")
WORDS = {"confirmed": "holds", "refuted": "fails", "conditional": "holds if", "not decided": "not decided"}
LONGEST = 25  # words


def verdict_word(verdict):
    return WORDS.get(verdict, verdict)


def capital(text):
    return text[:1].upper() + text[1:]


def sayings(text):
    return [form.format(*match.groups()) for pattern, form in SAYINGS if (match := pattern.search(text))]


def side_words(verdict, text):
    """One side of a claim: where it is true, else what became of it."""
    said = " and ".join(sayings(text or ""))
    if verdict == "confirmed":
        return "holds at every size judged"
    if verdict == "conditional":
        return f"holds {said or 'under conditions'}"
    return ", ".join(filter(None, (verdict_word(verdict), said)))


def sides(condition):
    return [f"Beside {SIDES[side]}: {side_words(verdict, text)}." for side, verdict, text in SIDE.findall(condition)]


def plain_condition(finding):
    """Of one folder's finding, a dict; empty where there is no condition."""
    condition = finding["condition"]
    if found := sides(condition):
        return " ".join(found)
    if smaller := SMALLER.search(condition):
        return f"Today's strongest photon map is the smaller one below {smaller.group(1)} hits."
    if lacking := LACKING.search(condition):
        return f"Too few runs from {lacking.group(1)} hits on." if finding["verdict"] == "not decided" else ""
    if said := sayings(condition):
        return capital(f"{' and '.join(said)}.")
    return capital(f"{condition}.") if condition and len(condition.split()) <= LONGEST else ""
