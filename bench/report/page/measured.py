"""How it was measured, in one screen: each part by itself, since parts of other machines or commits are not joined."""

from report.page.markup import details, joined, link, table, tag
from report.page.words import date_text, plural
from report.text import bytes_text

NOT_RECORDED = "not recorded"


def instructions_text(context):
    """The instruction set that Embree used; results from before it was recorded have at most the compiler's flag."""
    if known := context.get("instruction_set"):
        return known
    built = next((flag for flag in str(context.get("flags", "")).split() if flag.startswith("-march=")), None)
    return f"{NOT_RECORDED}; built with {built}" if built else NOT_RECORDED


def seeds_text(source):
    """Seeds or repetitions, from the context or the rows."""
    document = source.document
    if isinstance(document, dict) and "scenes" in document and "definitions" in document:
        seeds = {p["seeds"] for s in document["scenes"].values() for m in s["methods"].values() for p in m}
        return plural(max(seeds), "seed") if len(seeds) == 1 else f"{min(seeds)} to {max(seeds)} seeds"
    context = source.context
    parts = [f"{key} {context[key]}" for key in ("seed", "repetitions") if key in context]
    rows = document.get("rows") if isinstance(document, dict) else None
    if not parts and rows and "seeds" in rows[0]:
        parts = [f"{max(r['seeds'] for r in rows)} seeds a case"]
    return ", ".join(parts) or NOT_RECORDED


def libraries_text(context):
    return ", ".join(f"{name} {version}" for name, version in context.get("libraries", {}).items()) or NOT_RECORDED


def memory_text(context):
    memory = context.get("memory_bytes")
    return f"{context.get('cores', '?')} cores, {bytes_text(memory)}" if memory else NOT_RECORDED


def facts(source):
    context = source.context
    return (
        context.get("machine", NOT_RECORDED),
        instructions_text(context),
        memory_text(context),
        str(context.get("threads", NOT_RECORDED)),
        str(context.get("commit", NOT_RECORDED)),
        date_text(context.get("date")),
        context.get("compiler", NOT_RECORDED),
        seeds_text(source),
    )


def grouped(results):
    """One row for all that was made alike, of one commit, machine and day."""
    found = {}
    for name, source in parts(results):
        found.setdefault(facts(source), []).append(link(results.link(source.file), name))
    return [(joined(links, ", "), *key) for key, links in found.items()]


HEADS = ("results", "machine", "instruction set", "cores, memory", "threads", "commit", "date", "compiler", "seeds, repetitions")


PARTS = ("studies", "comparisons", "limits", "stability", "bases", "fits", "promises", "elsewhere", "realtime")


def name_of(part, source):
    """study, comparison billion, limit cornell-262144, fit cornell/10-bytes"""
    kind = {"studies": "study"}.get(part, part.removesuffix("s"))
    if part == "limits":
        return source.file.stem.replace("limit-", "limit ")
    where = "/".join(source.file.parts[-3:-1]) if part == "fits" else source.name
    return where if where in (kind, part) else f"{kind} {where}"


def parts(results):
    """(name, source), every file of results that says how it was made."""
    sources = [(part, source) for part in PARTS for source in getattr(results, part)]
    return [(name_of(part, s), s) for part, s in sources if isinstance(s.document, dict) and "context" in s.document]


def charted_words(results):
    if not results.study:
        return "No study is charted here."
    others = [s.name for s in results.studies if s is not results.study]
    more = f" Other studies here are not joined to it: {', '.join(others)}." if others else ""
    return f"The charts and the chooser above are of one study, {results.study.name}.{more}"


REPORTS = ("report.md", "stability.md", "bases.md", "fit.md", "model-bytes.md", "crosscheck.md", "verdicts.md", "promise/promise.md")


def reports(results):
    """Links to what people have in words."""
    there = [folder / name for folder in results.folders for name in REPORTS if (folder / name).is_file()]
    words = [link(results.link(path), f"{path.parent.resolve().name}/{path.name}") for path in there]
    return tag("p", "Reports: ", joined(words, ", "), ".") if words else None


def section(results):
    found = parts(results)
    context = (results.study or found[0][1]).context if found else {}
    definition = results.study.document.get("definitions", {}).get("metric", "") if results.study else ""
    return joined(
        [
            tag("p", charted_words(results)),
            table(HEADS, grouped(results), cls="wrap"),
            tag("p", f"Flags: {context.get('flags', NOT_RECORDED)}. Libraries: {libraries_text(context)}. Settings: {context.get('settings', NOT_RECORDED)}."),
            reports(results),
            details("what an error is, exactly", tag("p", definition)) if definition else None,
        ]
    )
