"""The paper's claims, held against a comparison's rows.

Each claim gives a verdict (confirmed, refuted, conditional: true only under the stated condition, not decided: lost in the
noise, not measured yet) and what was measured. Times are compared by medians; a difference counts only where the ranges over the repetitions do
not touch.
"""

from report.claims.billion_hits import billion_hits
from report.claims.finding import Finding, not_measured
from report.claims.study_claims import CONVERGES, NORMAL_MAPS, accuracy_crossings, converges, normal_maps
from report.compare.baselines import (
    BYTES,
    GATHER_US,
    INSERT_AND_BUILD_NS,
    INSERT_NS,
    MAP_SECONDS,
    answers_as_the_reference,
    engine_of,
    incremental,
    outcome,
    strongest,
)
from report.compare.memory_wall import light_map_peaks, peak_bound
from report.study.methods import REFERENCE_LIGHT_MAP
from report.text import bytes_text, count_text

NOT_MEASURED = "not measured"


def rows_of(comparison, method):
    return [row for scene in comparison.scenes for row in comparison.series(scene, method)]


def light_map_rows(comparison, is_counted=lambda row: True):
    """Per scene, those that count."""
    return {scene: [row for row in comparison.series(scene, comparison.light_map) if is_counted(row)] for scene in comparison.scenes}


def baseline_rows(comparison, baseline, is_counted=lambda row: True):
    return {scene: [row for row in baseline.series(comparison, scene) if is_counted(row)] for scene in comparison.scenes}


def spread_over_hits(rows, figure):
    """Per scene: largest over smallest median as the hits grow."""
    values = {scene: [figure.value(row) for row in series] for scene, series in rows.items() if len(series) > 1}
    return {scene: max(v) / min(v) for scene, v in values.items()}


def sure_spread(rows, figure):
    """The part of the spread that noise cannot explain: between the rows' ranges over the repetitions, not their medians."""
    ranges = {scene: [figure.bounds(row) for row in series] for scene, series in rows.items() if len(series) > 1}
    return {scene: max(1.0, max(low for low, _ in r) / min(high for _, high in r)) for scene, r in ranges.items()}


def sure_growth(rows, figure):
    """How often more a larger size costs than a smaller one, beyond the noise; 1 where it costs less."""
    bounds = {scene: [figure.bounds(row) for row in series] for scene, series in rows.items() if len(series) > 1}
    return {scene: max([1.0] + [low / high for i, (_, high) in enumerate(b) for low, _ in b[i + 1:]]) for scene, b in bounds.items()}


def verdict_by_spread(spreads, sure, bound):
    """The bound is what still counts as constant; between the two spreads lies what noise may have done."""
    grows = [spread >= bound for spread in sure.values()]
    if any(grows):
        return "refuted" if all(grows) else "conditional"
    return "confirmed" if max(spreads.values()) < bound else "not decided"


def constancy_against(own, baseline_growth, bound):
    """What a constant light map is worth beside this baseline: nothing where that does not grow either."""
    if not baseline_growth:
        return NOT_MEASURED
    if own != "confirmed":
        return own
    return "confirmed" if any(growth >= bound for growth in baseline_growth.values()) else "no difference: it does not grow either"


def listing(values, form="{:.2f}"):
    return ", ".join(f"{name} {form.format(value)}" for name, value in values.items()) or NOT_MEASURED


def hits_range(rows):
    return f"{count_text(min(r['hits_asked'] for r in rows))} to {count_text(max(r['hits_asked'] for r in rows))} hits"


def verdict_by_hits(outcomes):
    """Confirmed or refuted where all outcomes agree; else conditional, with the hits from which on the light map wins."""
    if not outcomes:
        return NOT_MEASURED, ""
    if all(o < 0 for _, o in outcomes):
        return "confirmed", ""
    if all(o >= 0 for _, o in outcomes):
        return "refuted", ""
    losing = [hits for hits, o in outcomes if o >= 0]
    winning = [hits for hits, o in outcomes if o < 0 and hits > max(losing)]
    if winning:
        return "conditional", f"true in every scene from {count_text(min(winning))} hits on, not at {count_text(max(losing))} and below"
    return "conditional", "true in some scenes only"


def combined(first, second):
    """One verdict of the two; where only one is there, that one."""
    measured = {v for v in (first, second) if v != NOT_MEASURED}
    return measured.pop() if len(measured) == 1 else "conditional" if measured else "not measured yet"


def ratios_text(pairs, figure, form, place):
    """The baseline's figure over the light map's, by scene; with the engine where it is not always the same one."""
    engines = {engine_of(theirs) for *_, theirs in pairs}
    texts = {}
    for scene, mine, theirs in pairs:
        engine = f" ({engine_of(theirs)})" if len(engines) > 1 else ""
        texts.setdefault(scene, []).append(form.format(figure.value(theirs) / figure.value(mine)) + f" x at {place(mine)}{engine}")
    of = f"{engines.pop()}: " if len(engines) == 1 else ""
    return of + "; ".join(f"{scene} " + ", ".join(t) for scene, t in texts.items()) if pairs else NOT_MEASURED


def tracing_speed(comparison):
    says = "SHLM tracing is faster, since there is no kd-tree insertion"
    verdicts, clauses = [], []
    for baseline in (incremental(comparison), strongest(comparison, MAP_SECONDS)):
        pairs = baseline.pairs(comparison)
        verdict, condition = verdict_by_hits([(mine["hits_asked"], outcome(mine, theirs, MAP_SECONDS)) for _, mine, theirs in pairs])
        verdicts.append(verdict)
        clauses.append(f"Against {baseline.name}: {verdict}" + (f" ({condition})" if condition else "")
                       + f": {ratios_text(pairs, MAP_SECONDS, '{:.2f}', lambda row: count_text(row['hits_asked']))}.")
    overall = combined(*verdicts)
    if overall == "not measured yet":
        return Finding("tracing-speed", says, overall, "needs shlm and a photon map")
    return Finding("tracing-speed", says, overall,
                   "Time to a finished map (an empty store, trace, insert, build), photon map over SHLM. " + " ".join(clauses), *verdicts)


def constant_insert(comparison):
    says, bound = "Accumulating a photon into SH coefficients takes constant time", 1.25
    texels = max((row["texels"] for row in rows_of(comparison, comparison.light_map)), default=0)
    def filled(row):
        return row["hits"] >= texels

    rows = light_map_rows(comparison, filled)
    spreads, sure = spread_over_hits(rows, INSERT_NS), sure_spread(rows, INSERT_NS)
    if not spreads:
        return Finding("constant-insert", says, "not measured yet", "needs shlm at two numbers of hits of one per texel and more")
    own = verdict_by_spread(spreads, sure, bound)
    verdicts, clauses = [], []
    for baseline in (incremental(comparison), strongest(comparison, INSERT_AND_BUILD_NS)):
        theirs = baseline_rows(comparison, baseline, filled)
        verdicts.append(constancy_against(own, sure_growth(theirs, INSERT_AND_BUILD_NS), bound))
        clauses.append(f"{baseline.name} {listing(spread_over_hits(theirs, INSERT_AND_BUILD_NS))}")
    short = {f"{row['scene']} {count_text(row['hits_asked'])}": row["insert_ns_per_hit"]
             for row in rows_of(comparison, comparison.light_map) if not filled(row)}
    warm_up = f" Shorter runs pay for the first touch of texels and buffers; ns per hit: {listing(short, '{:.0f}')}." if short else ""
    return Finding("constant-insert", says, own,
                   f"Slowest over fastest median from one hit per texel on: {listing(spreads)}; beyond the noise (bound {bound}): {listing(sure)}. "
                   f"Photon maps, a hit's share of the build included: {'; '.join(clauses)}.{warm_up}", *verdicts)


def crossings(comparison, baseline):
    """Per scene: hits below which the baseline's map is the smaller one, by its bytes a hit at the largest size measured."""
    found = {}
    for scene in comparison.scenes:
        light, photons = comparison.series(scene, comparison.light_map), baseline.series(comparison, scene)
        if light and photons:
            found[scene] = count_text(light[-1]["bytes"] / (photons[-1]["bytes"] / photons[-1]["hits"]))
    return found


def peak_text(comparison):
    """What a light map's run adds to the process at its fullest, and whether that is within its bound."""
    texts = []
    for scene in comparison.scenes:
        if rows := light_map_peaks(comparison, scene):
            values = ", ".join(f"{bytes_text(row['peak_growth_bytes'])} at {count_text(row['hits_asked'])}" for row in rows)
            kept = all(row["peak_growth_bytes"] <= peak_bound(row) for row in rows)
            texts.append(f"{scene} {values}, {'within' if kept else 'past'} the bound of {bytes_text(peak_bound(rows[-1]))}")
    bound = "1.1 x the texels' bytes while they are filled + 64 MiB"
    return f" Added to the process at its fullest (bound: {bound}): {'; '.join(texts)}." if texts else f" Peak of the process: {NOT_MEASURED}."


def constant_memory(comparison):
    says = "Memory stays constant however many photons are traced"
    rows = rows_of(comparison, comparison.light_map)
    spreads = spread_over_hits(light_map_rows(comparison), BYTES)
    if not spreads:
        return Finding("constant-memory", says, "not measured yet", "needs shlm at two numbers of hits")
    bound = 1.01  # FLANN's part is measured at the allocator, whose bookkeeping varies
    own = "confirmed" if max(spreads.values()) < bound else "refuted"
    sizes = {scene: series[0]["bytes"] / 2**20 for scene in comparison.scenes if (series := comparison.series(scene, comparison.light_map))}
    verdicts, clauses = [], []
    for baseline in (incremental(comparison), strongest(comparison, BYTES)):
        verdicts.append(constancy_against(own, sure_growth(baseline_rows(comparison, baseline), BYTES), bound))
        if smaller := crossings(comparison, baseline):
            clauses.append(f" {baseline.name} is the smaller one below " + ", ".join(f"{h} hits ({s})" for s, h in smaller.items()) + ".")
    return Finding("constant-memory", says, own,
                   f"Bytes of the map, {hits_range(rows)}: largest over smallest {listing(spreads, '{:.4f}')}; MiB: {listing(sizes, '{:.1f}')}."
                   + "".join(clauses) + peak_text(comparison), *verdicts)


FEW, MANY, SAME_TIME = 10**5, 10**9, 1.05


def same_at_a_billion(comparison):
    """Whether a gather at 1e9 hits takes as long as at 1e5, within 5 %: verdict, text."""
    spreads, sure = {}, {}
    for scene in comparison.scenes:
        few, many = (comparison.row(scene, comparison.light_map, hits) for hits in (FEW, MANY))
        if few and many:
            (few_low, few_high), (many_low, many_high) = GATHER_US.bounds(few), GATHER_US.bounds(many)
            spreads[scene] = GATHER_US.value(many) / GATHER_US.value(few)
            sure[scene] = max(1.0, many_low / few_high, few_low / many_high)
    if not spreads:
        return NOT_MEASURED, f"1e9 hits against 1e5: {NOT_MEASURED}"
    either_way = {scene: max(ratio, 1 / ratio) for scene, ratio in spreads.items()}
    verdict = verdict_by_spread(either_way, sure, SAME_TIME)
    return verdict, f"1e9 hits against 1e5 (within 5 %): {verdict}, {listing(spreads, '{:.3f}')}"


def constant_gather(comparison):
    says, bound = "Search time does not depend on the photon count", 1.15
    rows = light_map_rows(comparison)
    spreads, sure = spread_over_hits(rows, GATHER_US), sure_spread(rows, GATHER_US)
    if not spreads:
        return Finding("constant-gather", says, "not measured yet", "needs shlm at two numbers of hits")
    billion, billion_text = same_at_a_billion(comparison)
    own = verdict_by_spread(spreads, sure, bound)
    own = own if billion in (NOT_MEASURED, own) else min(own, billion, key=("refuted", "conditional", "not decided", "confirmed").index)
    verdicts, clauses = [], []
    for baseline in (incremental(comparison), strongest(comparison, GATHER_US, answers_as_the_reference)):
        theirs = baseline_rows(comparison, baseline)
        verdicts.append(constancy_against(own, sure_growth(theirs, GATHER_US), bound))
        clauses.append(f"{baseline.name} {listing(spread_over_hits(theirs, GATHER_US))}")
    return Finding("constant-gather", says, own,
                   f"Slowest over fastest median over {hits_range(rows_of(comparison, comparison.light_map))}: {listing(spreads)}; "
                   f"beyond the noise (bound {bound}): {listing(sure)}; {billion_text}. Photon maps: {'; '.join(clauses)}.", *verdicts)


def faster_gather(comparison, study):
    says = "The search is faster where more than one photon falls on a texel"
    verdicts, clauses, faster_below = [], [], []
    for baseline in (incremental(comparison), strongest(comparison, GATHER_US, answers_as_the_reference)):
        pairs = baseline.pairs(comparison)
        above = [(mine["hits_asked"], outcome(mine, theirs, GATHER_US)) for _, mine, theirs in pairs if mine["hits_per_texel"] > 1]
        faster_below += [outcome(mine, theirs, GATHER_US) < 0 for _, mine, theirs in pairs if mine["hits_per_texel"] <= 1]
        verdict, _ = verdict_by_hits(above)
        verdicts.append(verdict)
        clauses.append(f"Against {baseline.name}: {verdict}: "
                       + ratios_text(pairs, GATHER_US, "{:.1f}", lambda row: f"{row['hits_per_texel']:.2g}") + ".")
    overall = combined(*verdicts)
    if overall == "not measured yet":
        return Finding("faster-gather", says, overall, "needs more than one hit per texel")
    note = " It is faster below one hit per texel as well, so that this is not what decides." if faster_below and all(faster_below) else ""
    return Finding("faster-gather", says, overall,
                   f"Photon map's time per query over SHLM's, at hits per texel. {' '.join(clauses)}{note} "
                   + (accuracy_crossings(study) if study and comparison.light_map == REFERENCE_LIGHT_MAP else
                      "The errors are not equal, so this is a statement about time alone."), *verdicts)


def findings(comparison, study):
    """Of the comparison's light map. `study`: the summary.json of a study, None without one."""
    return [
        tracing_speed(comparison),
        constant_insert(comparison),
        constant_memory(comparison),
        constant_gather(comparison),
        faster_gather(comparison, study),
        normal_maps(study, comparison.light_map) if study else not_measured(*NORMAL_MAPS),
        converges(study, comparison.light_map) if study else not_measured(*CONVERGES),
        billion_hits(comparison),
    ]
