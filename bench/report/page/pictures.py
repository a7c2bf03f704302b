"""Pictures to compare: reference, light map, photon map, their differences and FLIP maps.

A study has a picture of each method's first seed at the reference's own points, all of one exposure, and its FLIP map beside it. They lie among the
raw answers, which the repository leaves out; so the page keeps those that it shows in STUDY/images/page, with what they are in pictures.json.
"""

import json
import shutil
from dataclasses import dataclass

from report.compare.comparison import Comparison
from report.page.find import read_json
from report.page.images import image
from report.page.markup import joined, link, tag
from report.page.quantities import percent_text
from report.page.words import PHOTON_MAP, family_text, origin_text
from report.study.images import BUDGET_HITS, TOLERANCE
from report.study.methods import LIGHT_MAP, REFERENCE_PHOTON_MAP
from report.text import bytes_text, hits_text, number_text, seconds_text

COSTS = {"time": (lambda r: r.seconds, seconds_text), "bytes": (lambda r: r.bytes, bytes_text)}
FAMILIES = {"light-map": LIGHT_MAP, "photon-map": PHOTON_MAP}
KEPT = "images/page"
MADE_BY = "Pictures are kept when the page is made beside a study's raw answers: ./reproduce does that."


def row_entry(study, row):
    return {
        "method": row.method,
        "hits": row.hits,
        "error": row.error,
        "bytes": row.bytes,
        "seconds": row.seconds,
        "flip": row.flip,
        "family": family_text(study.family(row.method)),
    }


def answers_by_run(study):
    """(scene, method, hits asked) -> file of the first seed's answers."""
    document = read_json(study.source.folder / "study.json") if (study.source.folder / "study.json").exists() else {"rows": []}
    return {(r["scene"], r["method"], r["hits_asked"]): study.source.folder / r["answers"] for r in document["rows"] if r.get("seed") == 1 and "answers" in r}


def picture_files(answers):
    """(picture, FLIP map) beside the answers of a run, as shlmbench study names them."""
    size = answers.stem.rsplit("-", 1)[0]
    return answers.with_name(f"{size}.png"), answers.with_name(f"{size}-flip.png")


def has_pictures(answers):
    return answers is not None and all(file.exists() for file in picture_files(answers))


def budgets(study, scene):
    """What the reference photon map pays for about a million hits, in time and in bytes."""
    rows = [r for r in study.rows if r.scene == scene and r.method == REFERENCE_PHOTON_MAP]
    if not rows:
        return {}
    row = min(rows, key=lambda r: abs(r.hits - BUDGET_HITS))
    return {kind: cost_of(row) for kind, (cost_of, _) in COSTS.items()}


def best_within(rows, cost_of, limit):
    return min((r for r in rows if r.error and cost_of(r) <= TOLERANCE * limit), key=lambda r: r.error, default=None)


def chosen_runs(study, scene, answers):
    """kind of budget -> (limit, role -> Row): the most accurate run of each family within it that has a picture."""
    made = {}
    for kind, limit in budgets(study, scene).items():
        drawn = [r for r in study.rows if r.scene == scene and has_pictures(answers.get((scene, r.method, r.hits_asked)))]
        found = {role: best_within([r for r in drawn if study.family(r.method) == family], COSTS[kind][0], limit) for role, family in FAMILIES.items()}
        if all(found.values()):
            made[kind] = (limit, found)
    return made


def keep(study):
    """Copies what the page shows out of the raw answers, where they are; else nothing is changed."""
    answers, sets, folder = answers_by_run(study), [], study.source.folder
    kept = folder / KEPT
    for scene in study.scenes:
        reference = folder / "raw" / scene / "reference.png"
        runs = chosen_runs(study, scene, answers) if reference.exists() else {}
        for kind, (limit, found) in runs.items():
            entry = {"scene": scene, "within": kind, "limit": limit, "reference": f"{scene}-reference.png", "reference_error": study.reference_error(scene), "runs": {}}
            copy(reference, kept / entry["reference"])
            for role, row in found.items():
                picture, flip = picture_files(answers[scene, row.method, row.hits_asked])
                names = [f"{scene}-{kind}-{role}.png", f"{scene}-{kind}-{role}-flip.png"]
                copy(picture, kept / names[0])
                copy(flip, kept / names[1])
                entry["runs"][role] = {**row_entry(study, row), "picture": names[0], "flip_map": names[1]}
            sets.append(entry)
    if sets:
        document = {"commit": study.context.get("commit"), "sets": sets}
        (kept / "pictures.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def copy(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)


@dataclass(frozen=True)
class Item:
    role: str
    title: str
    file: str  # relative to the page
    words: str


@dataclass(frozen=True)
class Set:
    scene: str
    title: str
    items: tuple
    flips: dict  # role -> file


def run_words(run):
    flip = f", FLIP {number_text(run['flip'])}" if run.get("flip") is not None else ""
    return f"{run['method']}, {hits_text(run['hits'])} hits: error {percent_text(run['error'])}{flip}, {bytes_text(run['bytes'])}, {seconds_text(run['seconds'])}"


def kept_sets(results, study):
    """Of this study's commit only."""
    file = study.source.folder / KEPT / "pictures.json"
    if not file.exists() or (document := read_json(file))["commit"] != study.context.get("commit"):
        return []
    made = []
    for entry in document["sets"]:
        at = lambda name: results.link(file.parent / name)
        words = f"path traced, its own error {percent_text(entry['reference_error'])}"
        items = [Item("reference", "reference", at(entry["reference"]), words)]
        items += [Item(role, run["family"], at(run["picture"]), run_words(run)) for role, run in entry["runs"].items()]
        limit = COSTS[entry["within"]][1](entry["limit"])
        made.append(Set(entry["scene"], f"within the same {entry['within']}, {limit}", tuple(items), {role: at(run["flip_map"]) for role, run in entry["runs"].items()}))
    return made


def large_item(results, comparison, scene, role, methods):
    """Of the first of these methods that has a picture; engines of a photon map find the same photons."""
    for method in methods:
        file, rows = comparison.folder / "images" / f"{scene}-{method.replace('/', '-')}.png", comparison.series(scene, method)
        if rows and file.exists():
            words = f"{method}, {hits_text(rows[-1]['hits'])} hits: {bytes_text(rows[-1]['bytes'])}; its error was not measured in this run"
            return Item(role, role.replace("-", " "), results.link(file), words)
    return None


def comparison_sets(results, source):
    """Large pictures, at each method's most hits, without a reference of their size."""
    comparison, made = Comparison(source.folder), []
    photon_maps = [m for m in comparison.methods if comparison.engine(m)]
    for scene in comparison.scenes:
        items = (large_item(results, comparison, scene, "light-map", [comparison.light_map]), large_item(results, comparison, scene, "photon-map", photon_maps))
        if all(items):
            made.append(Set(scene, f"large, {source.name}", items, {}))
    return made


def shown(title, picture, words, role):
    return tag("figure", tag("div", picture, cls="picture"), tag("figcaption", tag("b", title), " ", words), data_role=role)


def difference(results, reference, item):
    """Laid over each other; the style takes one from the other."""
    both = joined([image(results, reference.file, "reference"), image(results, item.file, f"{item.title} less the reference")])
    words = tag("figcaption", tag("b", "difference"), f" of {item.title} and reference, four times as bright")
    return tag("figure", tag("div", both, cls="picture difference"), words)


def strip(results, one):
    """Beside each other: the pictures, and of each but the reference its difference and its FLIP map."""
    figures = []
    first = one.items[0]
    for item in one.items:
        figures.append(shown(item.title, image(results, item.file, f"{one.scene}, {item.title}: {item.words}"), item.words, item.role))
        if first.role == "reference" and item is not first:
            figures.append(difference(results, first, item))
        if flip := one.flips.get(item.role):
            figures.append(shown("FLIP", image(results, flip, f"FLIP map of the {item.title}"), f" of the {item.title}: bright where eyes see the error", None))
    return tag("div", tag("h3", f"{one.scene}, {one.title}"), tag("div", *figures, cls="strip"), cls="pictures", data_scene=one.scene, data_title=one.title)


def billion(results):
    """The largest picture there is, where it was made."""
    made = []
    for folder in results.folders:
        for file in sorted((folder / "figure").glob("*.jpg")):
            context = results.context_of(folder.resolve().name)
            words = f"{folder.name}: as many hits as memory holds, light map beside photon map" + (f" ({origin_text(context)})" if context else "")
            there = link(results.link(folder / "report.md"), "its report")
            made.append(tag("figure", link(results.link(file), image(results, results.link(file), words)), tag("figcaption", f"{words}; ", there, "."), cls="large"))
    return joined(made)


def sets_of(results, study):
    sets = kept_sets(results, study) if study else []
    for source in results.comparisons:
        sets += comparison_sets(results, source)
    return sets


WORDS = (
    "Small pictures: the light that arrives at the points of the reference, without the surfaces' colours, by the first seed and with one exposure for a scene. "
    "Each is the most accurate run of its kind of map within the time or the bytes named. "
    "Large pictures: the whole image with its materials, at each map's most hits. They have no reference of their size."
)


def section(results, study):
    if study:
        keep(study)
    sets = sets_of(results, study)
    if not sets:
        return joined([tag("p", MADE_BY), billion(results)])
    origins = [tag("p", f"{s.name}: {origin_text(s.context)}.", cls="origin") for s in ([study.source] if study else []) + results.comparisons]
    return joined([tag("p", WORDS), tag("div", id="viewer", cls="script-only"), tag("div", *(strip(results, one) for one in sets), id="strips"), *origins, billion(results)])
