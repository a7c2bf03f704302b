""" "I need 5 %": the cheapest method of each family and its number of hits, read between the measured sizes, and the command that makes it."""

import math
from dataclasses import dataclass

import numpy as np

from report.page.markup import joined, table, tag
from report.page.quantities import percent_text
from report.page.rows import Row
from report.page.words import family_text
from report.study.targets import costs_to_reach
from report.text import bytes_text, hits_text, number_text, seconds_text

TARGET = 5.0  # per cent, at first

@dataclass(frozen=True)
class Offer:
    """One method where its error first falls to the target, read between the sizes on both sides; else its most accurate run."""

    family: str
    reached: bool
    row: Row  # the first run within the target; the most accurate one where none is
    before: Row  # the last run outside it; None where the first size is enough already, and where none is
    hits: float
    seconds: float
    bytes: float
    most_hits: int  # tried


def by_method(rows):
    """Runs of each method, hits ascending."""
    found = {}
    for row in sorted(rows, key=lambda r: r.hits_asked):
        found.setdefault(row.method, []).append(row)
    return found.values()


def reach(family, runs, target):
    """The offer of one method; None where it does not reach the target. In log-log, as the study's report reads between sizes."""
    first = next((i for i, r in enumerate(runs) if r.error <= target), None)
    if first is None:
        return None
    errors = np.array([[r.error**2 for r in runs]])
    paid = [float(costs_to_reach(np.array([[of(r) for r in runs]]), errors, target**2)[0]) for of in (lambda r: r.hits_asked, lambda r: r.seconds, lambda r: r.bytes)]
    return Offer(family, True, runs[first], runs[first - 1] if first else None, *paid, runs[-1].hits_asked)


def nearest(family, rows):
    best = min(rows, key=lambda r: r.error)
    return Offer(family, False, best, None, best.hits_asked, best.seconds, best.bytes, max(r.hits_asked for r in rows))


def offers(study, scene, target, cost):
    """One a family, those that reach the target first, the cheapest first."""
    found = []
    for family in study.families:
        rows = [r for r in study.rows if r.scene == scene and study.family(r.method) == family and r.error is not None]
        if not rows:
            continue
        reached = [offer for runs in by_method(rows) if (offer := reach(family, runs, target))]
        found.append(min(reached, key=lambda o: getattr(o, cost)) if reached else nearest(family, rows))
    return sorted(found, key=lambda o: (not o.reached, getattr(o, cost) if o.reached else o.row.error))


def hits_word(hits):
    """For a command line, two digits, rounded up: 2.4e6"""
    step = 10.0 ** (math.floor(math.log10(hits)) - 1)
    mantissa, exponent = f"{math.ceil(hits / step - 1e-9) * step:.1e}".split("e")
    return f"{float(mantissa):g}e{int(exponent)}"


def command_form(study, name):
    """Draws a scene as the study's runs of this method were measured, but for the seed; SCENE and HITS are to be filled in."""
    words = ["build/release/shlmbench render build/release/scenes/SCENE.glb --method", name, "--hits HITS"]
    kind = study.kinds[name]
    if kind.texels and not kind.fields.get("texels"):
        words.append(f"--texels {study.setting_texels or kind.texels}")
    return " ".join([*words, "--out picture.exr"])


def command(study, offer):
    return command_form(study, offer.row.method).replace("SCENE", offer.row.scene).replace("HITS", hits_word(offer.hits))


def ratio_text(offer, found, cost):
    """Beside the cheapest."""
    if not offer.reached or len([o for o in found if o.reached]) < 2:
        return ""
    return f"{number_text(getattr(offer, cost) / getattr(found[0], cost), 2)} ×"


def measured_text(offer):
    """The runs that the figures lie between."""
    return ", ".join(f"{percent_text(r.error)} at {hits_text(r.hits_asked)}" for r in (offer.before, offer.row) if r)


def method_cell(name, words=None):
    return joined([tag("b", name), tag("code", words, cls="command") if words else None], " ")


def offer_cells(study, scene, found, offer, cost):
    family = family_text(offer.family)
    if not offer.reached:
        words = f"not reached up to {hits_text(offer.most_hits)} hits: best is {percent_text(offer.row.error)}"
        return [scene, family, words, "", "", "", "", method_cell(offer.row.method)]
    least = "" if offer.before else "at most "
    return [
        scene,
        family,
        least + hits_text(offer.hits),
        least + seconds_text(offer.seconds),
        bytes_text(offer.bytes),
        ratio_text(offer, found, cost),
        measured_text(offer),
        method_cell(offer.row.method, command(study, offer)),
    ]


HEADS = ("scene", "map", "hits", "time", "finished bytes", "beside the cheapest", "errors measured", "method and command")


def static_table(study):
    """All scenes, by time, for those without the script."""
    rows = []
    for scene in study.scenes:
        found = offers(study, scene, TARGET, "seconds")
        rows += [offer_cells(study, scene, found, offer, "seconds") for offer in found]
    return table(HEADS, rows, cls="offers")


def option(value, text, chosen=False):
    return tag("option", text, value=value, selected=chosen)


def controls(study):
    scenes = joined([option("", "every scene", True), *(option(s, s) for s in study.scenes)])
    costs = joined([option("seconds", "time", True), option("bytes", "finished bytes")])
    return tag(
        "p",
        tag("label", "I need ", tag("input", type="number", id="target", value=f"{TARGET:g}", min="0.1", max="1000", step="any"), " % error"),
        tag("label", " in ", tag("select", scenes, id="target-scene")),
        tag("label", " by ", tag("select", costs, id="target-cost")),
        cls="controls script-only",
    )


def section(study):
    return joined(
        [
            tag(
                "p",
                "The cheapest method of each kind of map, chosen in hindsight. Sizes are measured a factor of ten apart; hits, time and bytes are read "
                "between the two runs beside the target, whose errors are shown.",
            ),
            controls(study),
            tag("div", static_table(study), id="offers", aria_live="polite"),
        ]
    )


def data(study):
    """What the script needs beyond the rows; it fills commands in as `command` does."""
    names = dict.fromkeys(row.method for row in study.rows)
    return {
        "families": {family: family_text(family) for family in study.families},
        "familyOf": {name: study.family(name) for name in names},
        "commands": {name: command_form(study, name) for name in names},
        "heads": HEADS,
    }
