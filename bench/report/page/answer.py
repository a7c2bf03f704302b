"""The answer in five lines, from the results at hand: the head of the page, and what the command prints."""

from report.page.chooser import TARGET, offers
from report.page.claims import finding_text
from report.page.measured import seeds_text
from report.page.quantities import percent_text
from report.page.words import PHOTON_MAP, listed, origin_text, plural
from report.study.methods import LIGHT_MAP
from report.text import bytes_text, hits_text, number_text, seconds_text

NO_STUDY = "Who reaches an error first is not known here: ./reproduce measures it."


def claims_line(results):
    return finding_text(results.verdicts[0].document) if results.verdicts else "The paper's claims are not judged here: bench/report verdicts does that."


def of_families(study, scene):
    """The fastest of each of the two families to the target; None where it was not measured."""
    found = {offer.family: offer for offer in offers(study, scene, TARGET, "seconds")}
    return found.get(LIGHT_MAP), found.get(PHOTON_MAP)


def offer_text(offer):
    if offer is None:
        return "not measured"
    return f"{seconds_text(offer.seconds)}, {bytes_text(offer.bytes)}" if offer.reached else f"{percent_text(offer.row.error)} at best"


def first_line(study):
    """Who reaches the target first, by scene."""
    firsts = {"light map": [], "photon map": [], "nobody": []}
    for scene in study.scenes:
        first = min((o for o in of_families(study, scene) if o and o.reached), key=lambda o: o.seconds, default=None)
        firsts["nobody" if first is None else "light map" if first.family == LIGHT_MAP else "photon map"].append(scene)
    words = [f"{who} in {listed(scenes)}" for who, scenes in firsts.items() if scenes]
    return f"First to {TARGET:g} % error: {'; '.join(words)}."


def cost_line(study):
    """Light map against photon map; scenes where nobody is there yet are left to the line before."""
    words = []
    for scene in study.scenes:
        pair = of_families(study, scene)
        if any(offer and offer.reached for offer in pair):
            words.append(f"{scene} {' against '.join(map(offer_text, pair))}")
    return f"Light map against photon map at {TARGET:g} %: {'; '.join(words)}." if words else f"Nobody reaches {TARGET:g} % here; see the best of each below."


def leaders(study, hits):
    """Per scene: (best light map, best photon map) at this number of hits."""
    found = {}
    for scene in study.scenes:
        rows = [r for r in study.rows if r.scene == scene and r.hits_asked == hits and r.error]
        best = [min((r for r in rows if study.family(r.method) == f), key=lambda r: r.error, default=None) for f in (LIGHT_MAP, PHOTON_MAP)]
        if all(best):
            found[scene] = best
    return found


def hits_line(study):
    """Who is the more accurate one at the fewest and at the most hits."""
    sizes = sorted({row.hits_asked for row in study.rows})
    words = []
    for hits in (sizes[0], sizes[-1]):
        found = leaders(study, hits)
        wins = [scene for scene, (light, photon) in found.items() if photon.error < light.error]
        words.append(f"at {hits_text(hits)} hits in {len(wins)} of {plural(len(found), 'scene')}")
    return f"The best photon map is the more accurate one {', '.join(words)}."


def bytes_line(study):
    """Bytes of the best maps at the most hits."""
    most = max(row.hits_asked for row in study.rows)
    pairs = leaders(study, most).values()
    if not pairs:
        return ""
    ratios = sorted(photon.bytes / light.bytes for light, photon in pairs)
    span = " to ".join(dict.fromkeys(f"{r:.0f}" if r >= 100 else number_text(r, 2) for r in (ratios[0], ratios[-1])))
    return f"At {hits_text(most)} hits that photon map takes {span} times the light map's bytes."


def trust_line(results):
    source = results.study or next(iter(results.comparisons), None)
    if source is None:
        return "Nothing here says on which machine it was measured."
    context = source.context
    scenes = f", {seeds_text(source)}, {plural(len(source.document['scenes']), 'scene')} of this project" if results.study else ""
    return f"Measured on {origin_text(context)}{scenes}."


def lines(results, study):
    """Five."""
    if study is None:
        return [claims_line(results), NO_STUDY, trust_line(results)]
    return [
        claims_line(results),
        first_line(study),
        cost_line(study),
        " ".join(filter(None, (hits_line(study), bytes_line(study)))),
        trust_line(results),
    ]
