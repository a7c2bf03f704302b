"""Which methods a chart draws: a chart of all of them cannot be read."""

import numpy as np

from report.study.methods import (
    FIXED_K,
    FIXED_RADIUS,
    GROWING_K,
    LIGHT_MAP,
    REFERENCE_LIGHT_MAP,
    REFERENCE_PHOTON_MAP,
    TRADITIONAL_LIGHT_MAP,
)

LARGEST_GROUP = 8


def of_family(methods, family):
    return [m for m in methods if m.family == family]


def errors_at_common_size(curves):
    """Of each curve of one scene at the largest size that all of them have, if there is one."""
    sizes = set.intersection(*({p.run.hits_asked for p in c.points} for c in curves)) if curves else set()
    if not sizes:
        return {}
    return {c.method.name: p.split.error for c in curves for p in c.points if p.run.hits_asked == max(sizes)}


def best(curves_by_scene, names):
    """The one with the smallest geometric mean of the error over the scenes; None where there is nothing.

    `curves_by_scene`: scene -> name -> Curve. Only methods that were measured in the most scenes compete.
    """
    logs = {name: [] for name in names}
    for curves in curves_by_scene.values():
        for name, error in errors_at_common_size([curves[n] for n in names if n in curves]).items():
            if error > 0:
                logs[name].append(np.log(error))
    most = max((len(values) for values in logs.values()), default=0)
    full = [name for name in names if most > 0 and len(logs[name]) == most]
    return min(full, key=lambda name: float(np.mean(logs[name])), default=None)


def best_known(methods, curves_by_scene):
    """The light map, its best size, the traditional light map, and the best of each kind of photon map."""
    names = [m.name for m in methods]
    plain = (REFERENCE_LIGHT_MAP, best(curves_by_scene, texel_variants(methods)))
    chosen = [n for n in dict.fromkeys((*plain, TRADITIONAL_LIGHT_MAP, REFERENCE_PHOTON_MAP)) if n in names]
    for family in (GROWING_K, FIXED_RADIUS):
        if name := best(curves_by_scene, [m.name for m in of_family(methods, family)]):
            chosen.append(name)
    return chosen


def light_map_variants(methods):
    """Of the default size: other orders first, then other gathers, then other weights."""

    plain = next((m for m in methods if m.name == REFERENCE_LIGHT_MAP), None)

    def distance(m):
        """From the reference, where the study has it."""
        if plain is None:
            return (0, False, False, m.order, m.name)
        return (
            (m.weight != plain.weight) + (m.gather != plain.gather) + (m.order != plain.order),
            m.weight != plain.weight,
            m.gather != plain.gather,
            m.order,
            m.name,
        )

    default = [m for m in of_family(methods, LIGHT_MAP) if m.texels == 0]
    first = [m for m in default if m.name == TRADITIONAL_LIGHT_MAP]
    rest = sorted((m for m in default if m.name != TRADITIONAL_LIGHT_MAP), key=distance)
    return [
        m.name for m in sorted((first + rest)[:LARGEST_GROUP], key=lambda m: (m.order, m.weight, m.gather))
    ]


def photon_map_variants(methods):
    """4 fixed k, 2 growing k, 2 radii; of each the reference, extreme discs, other kernels, the rest."""

    def by_use(kind):
        discs = sorted((m for m in kind if m.kernel == "disc"), key=lambda m: m.number)
        reference = [m for m in kind if m.name == REFERENCE_PHOTON_MAP]
        same_number = [m for m in kind if reference and m.number == reference[0].number]
        first = reference + discs[:1] + discs[-1:] + same_number[:2] + discs + kind
        return list(dict.fromkeys(first))

    quota = {FIXED_K: 4, GROWING_K: 2, FIXED_RADIUS: 2}
    kinds = {family: by_use(of_family(methods, family)) for family in quota}
    chosen = [m for family, count in quota.items() for m in kinds[family][:count]]
    spare = [m for family, count in quota.items() for m in kinds[family][count:]]
    chosen += spare[: LARGEST_GROUP - len(chosen)]
    return [
        m.name
        for m in sorted(
            chosen, key=lambda m: (list(quota).index(m.family), m.number, m.kernel != "disc", m.name)
        )
    ]


def texel_variants(methods):
    """The reference light map at every number of texels: the default first."""
    plain = next((m for m in methods if m.name == REFERENCE_LIGHT_MAP), None)

    def is_variant(m):
        same = ("family", "basis", "weight", "gather", "placement", "least_hits", "half")
        return plain is not None and all(getattr(m, key) == getattr(plain, key) for key in same)

    return [m.name for m in sorted(methods, key=lambda m: m.texels) if is_variant(m)]


GROUP_TITLES = {
    "methods": "light maps and photon maps",
    "shlm": "light map variants",
    "photonmap": "photon map variants",
    "texels": "light map sizes",
}
GROUP_TEXT = {
    "methods": "the light map, the traditional light map, the photon map with k = 50, and of the light map's "
    "sizes, of photon maps with growing k and of those with fixed radius the one with the smallest error at the "
    "largest size that all of its kind have, by geometric mean over the scenes",
    "shlm": f"up to {LARGEST_GROUP} light maps of the default size, those nearest to {REFERENCE_LIGHT_MAP}",
    "photonmap": f"up to {LARGEST_GROUP}: four fixed k, two growing k, two radii, the extreme disc kernels first",
    "texels": f"{REFERENCE_LIGHT_MAP} at every number of texels",
}


def groups(methods, curves_by_scene):
    """Group -> names; but for the first, groups of fewer than two are left out."""
    found = {
        "methods": best_known(methods, curves_by_scene),
        "shlm": light_map_variants(methods),
        "photonmap": photon_map_variants(methods),
        "texels": texel_variants(methods),
    }
    return {
        group: chosen for group, chosen in found.items() if len(chosen) > 1 or group == "methods" and chosen
    }
