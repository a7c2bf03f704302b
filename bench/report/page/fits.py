"""What each scene needs, as `shlmbench fit` finds it without a reference; and how often it keeps its word."""

from report.fit.search import KINDS
from report.fit.verdict import HEADS, cells
from report.page.markup import breakable, details, joined, link, table, tag
from report.page.quantities import percent_text
from report.page.words import MISSING, origin_text, plural

MISSING_TEXT = MISSING.format("./reproduce --models")


def parts_words(part):
    """A surface that the camera does not see has no error."""
    kinds = ", ".join(f"{100 * share:.0f} % {kind}" for kind, share in part["blocks"]["kinds"].items()) if part.get("blocks") else ""
    share = f"{100 * part['error_share']:.0f} %" if "error_share" in part else "-"
    return (part["name"], share, *(percent_text(100 * part[key]) if key in part else "-" for key in ("error", "noise", "bias")), kinds)


def explanation(results, source):
    """Which surfaces the error of the chosen light map comes from."""
    fit = source.document
    parts = fit.get("explanation")
    if not parts:
        return None
    picture = source.folder / "explanation.png"
    return details(
        f"{fit['scene']}, {100 * fit['target']:g} %, least {fit['least']}: where the light map's error comes from",
        table(("surface", "share of the error", "error", "noise", "bias", "what its blocks keep"), map(parts_words, parts)),
        tag("p", link(results.link(picture), "picture of what is kept where")) if picture.is_file() else None,
    )


def ratio_words(fits):
    """Photon map over light map in bytes, where both reach the target."""
    both = [f for f in fits if all(f[kind]["reached"] for kind in KINDS)]
    ratios = sorted(f["photon_map"]["choice"]["bytes"] / f["light_map"]["choice"]["bytes"] for f in both)
    if not ratios:
        return "No fit reaches its target with both maps."
    return f"Where fit reaches its target with both maps, the photon map takes {ratios[0]:.3g} to {ratios[-1]:,.0f} times the light map's bytes."


def promise_words(results):
    found = []
    for source in results.promises:
        sure = source.document["summary"]["sure"]
        rooms = source.document["rooms"]["count"]
        met = f"{sure['runs_that_meet']} of {sure['runs']} runs met the target that fit was sure of"
        found.append(tag("p", f"On {plural(rooms, 'random room')} {met} ({origin_text(source.context)})."))
    return joined(found)


def section(results):
    if not results.fits:
        return joined([tag("p", MISSING_TEXT), promise_words(results)])
    fits = [source.document for source in results.fits]
    origins = list(dict.fromkeys(origin_text(source.context) for source in results.fits))
    blocks = [explanation(results, source) for source in results.fits]
    return joined(
        [
            tag("p", ratio_words(fits), cls="finding"),
            promise_words(results),
            table(HEADS, [map(breakable, cells(fit, kind)) for fit in fits for kind in KINDS]),
            *blocks,
            tag("p", f"{'; '.join(origins)}.", cls="origin"),
        ]
    )
