"""What the runs can be filtered by: facts of the methods, as their rows say them. A method without a fact passes its filter."""

from report.page.words import family_text
from report.study.methods import FIXED_K, FIXED_RADIUS, GROWING_K
from report.text import hits_text

GATHERED = {FIXED_K: "k nearest", GROWING_K: "k grows with the hits", FIXED_RADIUS: "fixed radius"}


def blocks_text(fields):
    least = fields.get("least_hits")
    return None if least is None else f"share until {least} hits" if least else "each by itself"


FACETS = {  # key -> (title, value of a kind of the study; None where it has none)
    "family": ("map", lambda kind: family_text(kind.fields["family"]) if "family" in kind.fields else None),
    "basis": ("basis", lambda kind: kind.fields.get("basis")),
    "gather": ("gather", lambda kind: kind.fields.get("gather")),
    "texels": ("texels", lambda kind: hits_text(kind.texels) if kind.texels else None),
    "weight": ("a hit is", lambda kind: kind.fields.get("weight")),
    "blocks": ("texels", lambda kind: blocks_text(kind.fields)),
    "engine": ("engine", lambda kind: kind.fields.get("engine")),
    "gathered": ("photons", lambda kind: GATHERED.get(kind.method.family)),
    "kernel": ("kernel", lambda kind: kind.fields.get("kernel")),
}


FIRST_FACETS = ("family", "basis", "gather", "texels")  # the others stand behind a word


def facts_of(kind):
    return {key: value for key, (_, value_of) in FACETS.items() if (value := value_of(kind)) is not None}


def choices(study):
    """facet -> {value: number of rows}; only those that have something to choose."""
    counts = {}
    for row in study.rows:
        for key, value in facts_of(study.kinds[row.method]).items():
            counts.setdefault(key, {}).setdefault(value, 0)
            counts[key][value] += 1
    return {key: counts[key] for key in FACETS if len(counts.get(key, {})) > 1}
