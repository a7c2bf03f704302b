"""Words that several sections share."""

PHOTON_MAP = "photonmap"  # of the program's families, beside report.study.methods.LIGHT_MAP
FAMILY = {"shlm": "light map", PHOTON_MAP: "photon map"}  # what people call the program's families
MISSING = "Not measured here. {} makes it."


def family_text(family):
    return FAMILY.get(family, family)


def plural(count, word):
    return f"{count} {word}{'s' * (count != 1)}"


def listed(words):
    """a, b and c"""
    words = list(words)
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}" if words else ""


def date_text(text):
    """2026-11-30T08:18:54Z -> 2026-11-30"""
    return str(text or "date not recorded").split("T")[0]


def origin_text(context):
    """Machine, commit, date: what every panel says of itself."""
    seeds = f", seed {context['seed']}" if "seed" in context else ""
    threads = f", {context['threads']} threads" if "threads" in context else ""
    return (
        f"{context.get('machine', 'machine not recorded')}{threads}, commit {context.get('commit', 'not recorded')}, "
        f"{date_text(context.get('date'))}{seeds}"
    )
