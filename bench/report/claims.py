"""The paper's claims, held against a comparison's rows.

Each claim gives a verdict (confirmed, refuted, conditional: true only under the stated condition, not decided: lost in the
noise, not measured yet) and what was measured. Times are compared by medians; a difference counts only where the ranges over the repetitions do
not touch.
"""

from comparison import INCREMENTAL, LIGHT_MAP, MAP_COLUMNS, PHOTON_MAP, count_text, map_seconds
from finding import Finding, not_measured
from study_claims import CONVERGES, NORMAL_MAPS, accuracy_crossings, converges, normal_maps


def bounds(row, columns):
    """Smallest and largest sum of the columns over the repetitions, from their ranges."""
    low = sum(row[c + "_range"][0] for c in columns)
    high = sum(row[c + "_range"][1] for c in columns)
    return low, high


def outcome(mine, theirs, columns):
    """-1: mine is clearly less, 1: clearly more, 0: the ranges touch."""
    my_low, my_high = bounds(mine, columns)
    their_low, their_high = bounds(theirs, columns)
    return -1 if my_high < their_low else 1 if my_low > their_high else 0


def rows_of(comparison, method):
    return [row for scene in comparison.scenes for row in comparison.series(scene, method)]


def spread_over_hits(comparison, method, column, is_counted=lambda row: True):
    """Per scene: largest over smallest median as the hits grow, over the rows that count."""
    spreads = {}
    for scene in comparison.scenes:
        values = [row[column] for row in comparison.series(scene, method) if is_counted(row)]
        if len(values) > 1:
            spreads[scene] = max(values) / min(values)
    return spreads


def sure_spread(comparison, method, column, is_counted=lambda row: True):
    """The part of the spread that noise cannot explain: between the rows' ranges over the repetitions, not their medians."""
    spreads = {}
    for scene in comparison.scenes:
        ranges = [row[column + "_range"] for row in comparison.series(scene, method) if is_counted(row)]
        if len(ranges) > 1:
            spreads[scene] = max(1.0, max(low for low, _ in ranges) / min(high for _, high in ranges))
    return spreads


def verdict_by_spread(spreads, sure, bound):
    """The bound is what still counts as constant; between the two spreads lies what noise may have done."""
    grows = [spread >= bound for spread in sure.values()]
    if any(grows):
        return "refuted" if all(grows) else "conditional"
    return "confirmed" if max(spreads.values()) < bound else "not decided"


def listing(values, form="{:.2f}"):
    return ", ".join(f"{name} {form.format(value)}" for name, value in values.items())


def hits_range(rows):
    return f"{count_text(min(r['hits_asked'] for r in rows))} to {count_text(max(r['hits_asked'] for r in rows))} hits"


def against(comparison, other):
    """How the light map's time to a finished map compares: text, and the outcomes by number of hits."""
    outcomes, texts = [], []
    for scene in comparison.scenes:
        pairs = comparison.pairs(scene, LIGHT_MAP, other)
        outcomes += [(mine["hits_asked"], outcome(mine, theirs, MAP_COLUMNS)) for mine, theirs in pairs]
        texts += [f"{scene} " + ", ".join(f"{map_seconds(theirs) / map_seconds(mine):.2f} x at {count_text(mine['hits_asked'])}"
                                          for mine, theirs in pairs)] if pairs else []
    return outcomes, "; ".join(texts)


def verdict_by_hits(outcomes):
    """Confirmed or refuted where all outcomes agree; else conditional, with the hits from which on the light map wins."""
    if all(o < 0 for _, o in outcomes):
        return "confirmed", ""
    if all(o >= 0 for _, o in outcomes):
        return "refuted", ""
    losing = [hits for hits, o in outcomes if o >= 0]
    winning = [hits for hits, o in outcomes if o < 0 and hits > max(losing)]
    if winning:
        return "conditional", f"true in every scene from {count_text(min(winning))} hits on, not at {count_text(max(losing))} and below"
    return "conditional", "true in some scenes only"


def tracing_speed(comparison):
    says = "SHLM tracing is faster, since there is no kd-tree insertion"
    incremental, incremental_text = against(comparison, INCREMENTAL)
    bulk, bulk_text = against(comparison, PHOTON_MAP)
    if not incremental or not bulk:
        return Finding("tracing-speed", says, "not measured yet", "needs shlm and both photon maps")
    first, first_condition = verdict_by_hits(incremental)
    second, second_condition = verdict_by_hits(bulk)
    verdict = first if first == second and first != "conditional" else "conditional"
    def clause(name, v, condition):
        return f"against {name}: {v}" + (f" ({condition})" if condition else "")
    return Finding("tracing-speed", says, verdict,
                   f"Time to a finished map (an empty store, trace, insert, build), photon map over SHLM. "
                   f"{clause('insertion into a tree, as the paper words it', first, first_condition)}: {incremental_text}. "
                   f"{clause('appending and building the tree once', second, second_condition)}: {bulk_text}.")


def constant_insert(comparison):
    says = "Accumulating a photon into SH coefficients takes constant time"
    texels = max((row["texels"] for row in rows_of(comparison, LIGHT_MAP)), default=0)
    def filled(row):
        return row["hits"] >= texels

    spreads = spread_over_hits(comparison, LIGHT_MAP, "insert_ns_per_hit", filled)
    sure = sure_spread(comparison, LIGHT_MAP, "insert_ns_per_hit", filled)
    tree = spread_over_hits(comparison, INCREMENTAL, "insert_ns_per_hit", filled)
    if not spreads:
        return Finding("constant-insert", says, "not measured yet", "needs shlm at two numbers of hits of one per texel and more")
    short = {f"{row['scene']} {count_text(row['hits_asked'])}": row["insert_ns_per_hit"]
             for row in rows_of(comparison, LIGHT_MAP) if row["hits"] < texels}
    warm_up = f" Shorter runs pay for the first touch of texels and buffers; ns per hit: {listing(short, '{:.0f}')}." if short else ""
    return Finding("constant-insert", says, verdict_by_spread(spreads, sure, 1.25),
                   f"Slowest over fastest median from one hit per texel on: {listing(spreads)}; beyond the noise (bound 1.25): {listing(sure)}; "
                   f"tree insertion: {listing(tree)}.{warm_up}")


def constant_memory(comparison):
    says = "Memory stays constant however many photons are traced"
    rows = rows_of(comparison, LIGHT_MAP)
    if len(rows) < 2:
        return Finding("constant-memory", says, "not measured yet", "needs shlm at two numbers of hits")
    spreads = spread_over_hits(comparison, LIGHT_MAP, "bytes")
    same = max(spreads.values()) < 1.01  # FLANN's part is measured at the allocator, whose bookkeeping varies
    sizes = {scene: series[0]["bytes"] / 2**20 for scene in comparison.scenes if (series := comparison.series(scene, LIGHT_MAP))}
    crossings = {}
    for scene in comparison.scenes:
        light, photons = comparison.series(scene, LIGHT_MAP), comparison.series(scene, PHOTON_MAP)
        if light and photons:
            crossings[scene] = light[-1]["bytes"] / (photons[-1]["bytes"] / photons[-1]["hits"])
    text = f"Bytes of the map, {hits_range(rows)}: " + f"largest over smallest {listing(spreads, '{:.4f}')}"
    text += f"; MiB: {listing(sizes, '{:.1f}')}."
    if crossings:
        text += " The photon map is the smaller one below " + ", ".join(f"{count_text(h)} hits ({s})" for s, h in crossings.items()) + "."
    return Finding("constant-memory", says, "confirmed" if same else "refuted", text)


def constant_gather(comparison):
    says = "Search time does not depend on the photon count"
    light = spread_over_hits(comparison, LIGHT_MAP, "gather_us_per_query")
    tree = spread_over_hits(comparison, PHOTON_MAP, "gather_us_per_query")
    if not light:
        return Finding("constant-gather", says, "not measured yet", "needs shlm at two numbers of hits")
    sure = sure_spread(comparison, LIGHT_MAP, "gather_us_per_query")
    return Finding("constant-gather", says, verdict_by_spread(light, sure, 1.15),
                   f"Slowest over fastest median over {hits_range(rows_of(comparison, LIGHT_MAP))}: {listing(light)}; "
                   f"beyond the noise (bound 1.15): {listing(sure)}; "
                   f"photon map: {listing(tree)}.")


def faster_gather(comparison, study):
    says = "The search is faster where more than one photon falls on a texel"
    above, below = [], []
    for scene in comparison.scenes:
        for mine, theirs in comparison.pairs(scene, LIGHT_MAP, PHOTON_MAP):
            entry = (scene, mine["hits_per_texel"], theirs["gather_us_per_query"] / mine["gather_us_per_query"],
                     outcome(mine, theirs, ("gather_us_per_query",)))
            (above if mine["hits_per_texel"] > 1 else below).append(entry)
    if not above:
        return Finding("faster-gather", says, "not measured yet", "needs more than one hit per texel")
    ratios = ", ".join(f"{scene} {ratio:.1f} x at {hits:.2g}" for scene, hits, ratio, _ in above + below)
    all_above, any_below_lost = all(o < 0 for *_, o in above), any(o >= 0 for *_, o in below)
    verdict = "confirmed" if all_above else "refuted" if all(o >= 0 for *_, o in above) else "conditional"
    note = "" if any_below_lost or not below else " It is faster below one hit per texel as well, so that this is not what decides."
    return Finding("faster-gather", says, verdict,
                   f"Photon map's time per query over SHLM's, at hits per texel: {ratios}.{note} "
                   + (accuracy_crossings(study) if study else
                      "The errors are not equal, so this is a statement about time alone."))


def findings(comparison, study):
    """`study`: the summary.json of a study, None without one."""
    return [
        tracing_speed(comparison),
        constant_insert(comparison),
        constant_memory(comparison),
        constant_gather(comparison),
        faster_gather(comparison, study),
        normal_maps(study) if study else not_measured(*NORMAL_MAPS),
        converges(study) if study else not_measured(*CONVERGES),
        not_measured("billion-hits", "Over a billion hits on a desktop PC"),
    ]
