""" "I need 5 %": the cheapest measured row of each family, and the command that makes it. Nothing is interpolated."""

from dataclasses import dataclass

from report.page.markup import joined, table, tag
from report.page.quantities import percent_text
from report.page.rows import Row
from report.page.words import family_text
from report.text import bytes_text, hits_text, number_text, seconds_text

TARGET = 5.0  # per cent, at first
COSTS = {"seconds": lambda row: row.seconds, "bytes": lambda row: row.bytes}


@dataclass(frozen=True)
class Offer:
    family: str
    row: Row  # the cheapest that reaches the target, else the most accurate one
    reached: bool
    most_hits: int  # tried


def offers(study, scene, target, cost):
    """One a family, those that reach the target first, the cheapest first."""
    found = []
    for family in study.families:
        rows = [r for r in study.rows if r.scene == scene and study.family(r.method) == family and r.error]
        if not rows:
            continue
        within = [r for r in rows if r.error <= target]
        best = min(within, key=lambda r: (COSTS[cost](r), r.error)) if within else min(rows, key=lambda r: r.error)
        found.append(Offer(family, best, bool(within), max(r.hits_asked for r in rows)))
    return sorted(found, key=lambda o: (not o.reached, COSTS[cost](o.row) if o.reached else o.row.error))


def hits_word(hits):
    """For a command line: 1e7, 12345678"""
    text = f"{hits:.0e}".replace("e+0", "e").replace("e+", "e")
    return text if float(text) == hits else str(hits)


def command_form(study, name):
    """Draws a scene as the study's runs of this method were measured, but for the seed; SCENE and HITS are to be filled in."""
    words = ["build/release/shlmbench render build/release/scenes/SCENE.glb --method", name, "--hits HITS"]
    kind = study.kinds[name]
    if kind.texels and not kind.fields.get("texels"):
        words.append(f"--texels {study.setting_texels or kind.texels}")
    return " ".join([*words, "--out picture.exr"])


def command(study, row):
    return command_form(study, row.method).replace("SCENE", row.scene).replace("HITS", hits_word(row.hits_asked))


def ratio_text(offer, found, cost):
    """Beside the cheapest."""
    if not offer.reached or len([o for o in found if o.reached]) < 2:
        return ""
    return f"{number_text(COSTS[cost](offer.row) / COSTS[cost](found[0].row), 2)} ×"


def method_cell(name, words=None):
    return joined([tag("b", name), tag("code", words, cls="command") if words else None], " ")


def offer_cells(study, scene, found, offer, cost):
    family = family_text(offer.family)
    if not offer.reached:
        words = f"not reached up to {hits_text(offer.most_hits)} hits: best is {percent_text(offer.row.error)}"
        return [scene, family, words, "", "", "", method_cell(offer.row.method)]
    row = offer.row
    return [
        scene,
        family,
        percent_text(row.error),
        seconds_text(row.seconds),
        bytes_text(row.bytes),
        ratio_text(offer, found, cost),
        method_cell(row.method, command(study, row)),
    ]


HEADS = ("scene", "map", "error", "time", "finished bytes", "beside the cheapest", "method and command")


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
                "The cheapest measured run of each kind of map, chosen in hindsight. Nothing is interpolated here: numbers of hits are a factor of ten "
                "apart, so that a run may be better, and dearer, than was asked for. The five lines above read between the sizes.",
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
        "hitsWords": {str(row.hits_asked): hits_word(row.hits_asked) for row in study.rows},
        "heads": HEADS,
    }
