"""The paper's claims, held against a comparison's rows.

Each claim gives a verdict (confirmed, refuted, conditional: true only under the stated condition, not decided: lost in the
noise or measured in too few scenes or runs, not measured yet) and what was measured. Times are compared by medians; a difference
counts only where the ranges over the repetitions do not touch (judging.py).
"""

from report.claims.billion_hits import billion_hits
from report.claims.finding import NOT_DECIDED, NOT_MEASURED, NOT_MEASURED_YET, Finding, not_measured, sentence
from report.claims.judging import Outcome, has_enough_runs, judged, lacking_text, range_text, runs_of, sizes_in_all, verdict_by_hits, why_not_decided
from report.claims.study_claims import CONVERGES, NORMAL_MAPS, accuracy_crossings, converges, normal_maps
from report.compare.baselines import (
    BYTES,
    FIRST_MAP_SECONDS,
    GATHER_US,
    INSERT_AND_BUILD_NS,
    INSERT_NS,
    MAP_SECONDS,
    engine_of,
    incremental,
    is_as_accurate,
    sign_of,
    strongest,
)
from report.compare.memory_wall import light_map_peaks, peak_bound
from report.study.methods import REFERENCE_LIGHT_MAP
from report.text import bytes_text, count_text


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
    if not spreads:
        return NOT_DECIDED
    grows = [spread >= bound for spread in sure.values()]
    if any(grows):
        return "refuted" if all(grows) else "conditional"
    return "confirmed" if max(spreads.values()) < bound else NOT_DECIDED


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


def combined(first, second):
    """One verdict of the two; where only one is there, that one."""
    measured = {v for v in (first, second) if v != NOT_MEASURED}
    return measured.pop() if len(measured) == 1 else "conditional" if measured else NOT_MEASURED_YET


def ratios_text(pairs, figure, form, place):
    """The baseline's figure over the light map's, by scene; with the engine where it is not always the same one."""
    engines = {engine_of(theirs) for *_, theirs in pairs}
    texts = {}
    for scene, mine, theirs in pairs:
        engine = f" ({engine_of(theirs)})" if len(engines) > 1 else ""
        texts.setdefault(scene, []).append(form.format(figure.value(theirs) / figure.value(mine)) + f" x at {place(mine)}{engine}")
    of = f"{engines.pop()}: " if len(engines) == 1 else ""
    return of + "; ".join(f"{scene} " + ", ".join(t) for scene, t in texts.items()) if pairs else NOT_MEASURED


# --- faster, beside one photon map or another


def with_condition(text, condition):
    return f"{text} ({condition})" if condition else text


def outcomes_of(pairs, figure):
    return [
        Outcome(scene, mine["hits_asked"], min(mine["repetitions"], theirs["repetitions"]), sign_of(mine, theirs, figure))
        for scene, mine, theirs in pairs
    ]


def largest_judged(pairs, figure, scenes, form):
    """The ratio over all scenes at the largest size that is judged, in words, and the rows it is from."""
    ranges = ratio_ranges(pairs, figure, scenes)
    if not ranges:
        return "", []
    hits = max(ranges)
    return f"{range_text(ranges[hits], form)} x at {count_text(hits)} hits", [row for pair in pairs if pair[1]["hits_asked"] == hits for row in pair[1:]]


def ratio_ranges(pairs, figure, scenes):
    """hits -> (least, most) of the baseline's figure over the light map's, of those sizes that are judged."""
    signs, _ = judged(outcomes_of(pairs, figure), scenes)
    ratios = {hits: [figure.value(theirs) / figure.value(mine) for _, mine, theirs in pairs if mine["hits_asked"] == hits] for hits in signs}
    return {hits: (min(values), max(values)) for hits, values in ratios.items()}


def beside(comparison, baseline, figure, is_counted=lambda row: True):
    """(the pairs that count, the judgement) of the light map's figure being less than the baseline's."""
    pairs = [pair for pair in baseline.pairs(comparison) if is_counted(pair[1])]
    return pairs, verdict_by_hits(outcomes_of(pairs, figure), comparison.scenes)


def side_text(baseline, judgement):
    return with_condition(f"{baseline.name}: {judgement.verdict}", judgement.condition)


def plain_side(baseline, judgement):
    return f"Beside {baseline.plain_name}: {judgement.plain}."


def with_preparation(pairs):
    """Those whose preparation of the scene was timed."""
    return [pair for pair in pairs if all("prepare_seconds" in row for row in pair[1:])]


def both_clocks(pairs):
    """What the scene's preparation changes, where it was measured: the ratios with it."""
    timed = with_preparation(pairs)
    return f" With the preparation of the scene: {ratios_text(timed, FIRST_MAP_SECONDS, '{:.2f}', lambda row: count_text(row['hits_asked']))}." if timed else ""


def first_map_verdict(comparison, baseline):
    """Of the first map of a scene; None where preparation was not measured."""
    pairs = with_preparation(baseline.pairs(comparison))
    return verdict_by_hits(outcomes_of(pairs, FIRST_MAP_SECONDS), comparison.scenes) if pairs else None


def tracing_speed(comparison):
    says = "SHLM tracing is faster, since there is no kd-tree insertion"
    verdicts, clauses, conditions, plain, ratios = [], [], [], [], {}
    engine = strongest(comparison, MAP_SECONDS)
    for baseline in (incremental(comparison), engine):
        pairs, judgement = beside(comparison, baseline, MAP_SECONDS)
        ratios[baseline.name] = ratio_ranges(pairs, MAP_SECONDS, comparison.scenes)
        verdicts.append(judgement.verdict)
        conditions.append(side_text(baseline, judgement))
        plain.append(plain_side(baseline, judgement))
        clauses.append(f"Against {side_text(baseline, judgement)}"
                       + f": {ratios_text(pairs, MAP_SECONDS, '{:.2f}', lambda row: count_text(row['hits_asked']))}.{both_clocks(pairs)}")
    overall = combined(*verdicts)
    if overall == NOT_MEASURED_YET:
        return Finding("tracing-speed", says, overall, "needs shlm and a photon map")
    figure, rows = largest_judged(engine.pairs(comparison), MAP_SECONDS, comparison.scenes, "{:.2f}")
    if first := first_map_verdict(comparison, engine):
        conditions.append(with_condition(f"for the first map of a scene, its preparation included: {first.verdict}", first.condition))
        plain.append(f"The first map of a scene, its preparation included: {first.plain}.")
    return Finding("tracing-speed", says, overall,
                   "Time to a finished map (an empty store, trace, insert, build), photon map over SHLM. " + " ".join(clauses), *verdicts,
                   condition="; ".join(conditions), plain=" ".join(plain), figure=figure, ratios=ratios,
                   scenes=tuple(comparison.scenes), runs=runs_of(rows))


def faster_gather(comparison, study):
    says = "The search is faster where more than one photon falls on a texel"
    verdicts, clauses, conditions, plain, faster_below, ratios = [], [], [], [], [], {}
    engine = strongest(comparison, GATHER_US, is_as_accurate(comparison, study))
    for baseline in (incremental(comparison), engine):
        _, judgement = beside(comparison, baseline, GATHER_US, lambda row: row["hits_per_texel"] > 1)
        pairs = baseline.pairs(comparison)
        ratios[baseline.name] = ratio_ranges(pairs, GATHER_US, comparison.scenes)
        faster_below += [o.sign < 0 for o in outcomes_of([p for p in pairs if p[1]["hits_per_texel"] <= 1], GATHER_US)]
        verdicts.append(judgement.verdict)
        conditions.append(side_text(baseline, judgement))
        plain.append(plain_side(baseline, judgement))
        clauses.append(f"Against {side_text(baseline, judgement)}: "
                       + ratios_text(pairs, GATHER_US, "{:.1f}", lambda row: f"{row['hits_per_texel']:.2g}") + ".")
    overall = combined(*verdicts)
    if overall == NOT_MEASURED_YET:
        return Finding("faster-gather", says, overall, "needs more than one hit per texel")
    note = " It is faster below one hit per texel as well, so that this is not what decides." if faster_below and all(faster_below) else ""
    above = [pair for pair in engine.pairs(comparison) if pair[1]["hits_per_texel"] > 1]
    figure, rows = largest_judged(above, GATHER_US, comparison.scenes, "{:.1f}")
    return Finding("faster-gather", says, overall,
                   f"Photon map's time per query over SHLM's, at hits per texel. {' '.join(clauses)}{note} "
                   + (accuracy_crossings(study) if study and comparison.light_map == REFERENCE_LIGHT_MAP else
                      "The errors are not equal, so this is a statement about time alone."), *verdicts,
                   condition="; ".join(conditions), plain=" ".join(plain), figure=figure, ratios=ratios,
                   scenes=tuple(comparison.scenes), runs=runs_of(rows))


# --- constant, however many hits


def constant_insert(comparison):
    says, bound = "Accumulating a photon into SH coefficients takes constant time", 1.25
    texels = max((row["texels"] for row in rows_of(comparison, comparison.light_map)), default=0)

    def filled(row):
        return row["hits"] >= texels

    all_rows = light_map_rows(comparison, filled)
    if not spread_over_hits(all_rows, INSERT_NS):
        return Finding("constant-insert", says, NOT_MEASURED_YET, "needs shlm at two numbers of hits of one per texel and more")
    rows, lacking = sizes_in_all(all_rows)
    spreads, sure = spread_over_hits(rows, INSERT_NS), sure_spread(rows, INSERT_NS)
    own = verdict_by_spread(spreads, sure, bound)
    verdicts, clauses = [], []
    for baseline in (incremental(comparison), strongest(comparison, INSERT_AND_BUILD_NS)):
        theirs, _ = sizes_in_all(baseline_rows(comparison, baseline, filled))
        verdicts.append(constancy_against(own, sure_growth(theirs, INSERT_AND_BUILD_NS), bound))
        clauses.append(f"{baseline.name} {listing(spread_over_hits(theirs, INSERT_AND_BUILD_NS))}")
    each = {f"{row['scene']} {count_text(row['hits_asked'])}": INSERT_NS.value(row) for row in rows_of(comparison, comparison.light_map)}
    return Finding("constant-insert", says, own,
                   f"Slowest over fastest median from one hit per texel on: {listing(spreads)}; beyond the noise (bound {bound}): {listing(sure)}. "
                   f"Photon maps, a hit's share of the build included: {'; '.join(clauses)}. "
                   f"ns a hit and thread, the difference between walls with and without the store: {listing(each, '{:.0f}')}.", *verdicts,
                   condition=lacking_text(lacking), plain=why_not_decided(lacking) if own == NOT_DECIDED else "", figure=f"spread {range_text(spreads.values())}" if spreads else "",
                   scenes=tuple(spreads or all_rows), runs=runs_of([row for series in (rows if spreads else all_rows).values() for row in series]))


def crossings(comparison, baseline):
    """Per scene: hits below which the baseline's map is the smaller one, by its bytes a hit at the largest size measured."""
    found = {}
    for scene in comparison.scenes:
        light, photons = comparison.series(scene, comparison.light_map), baseline.series(comparison, scene)
        if light and photons:
            found[scene] = light[-1]["bytes"] / (photons[-1]["bytes"] / photons[-1]["hits"])
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
    """A map's bytes are the same in every run: sizes of one run count as well."""
    says = "Memory stays constant however many photons are traced"
    rows = rows_of(comparison, comparison.light_map)
    spreads = spread_over_hits(light_map_rows(comparison), BYTES)
    if not spreads:
        return Finding("constant-memory", says, NOT_MEASURED_YET, "needs shlm at two numbers of hits")
    bound = 1.01  # FLANN's part is measured at the allocator, whose bookkeeping varies
    own = "confirmed" if max(spreads.values()) < bound else "refuted"
    sizes = {scene: series[0]["bytes"] / 2**20 for scene in comparison.scenes if (series := comparison.series(scene, comparison.light_map))}
    working = {scene: series[-1].get("insert_bytes", 0) / 2**20 for scene in sizes if (series := comparison.series(scene, comparison.light_map))}
    verdicts, clauses, conditions, plain = [], [], [], []
    for baseline in (incremental(comparison), strongest(comparison, BYTES)):
        verdicts.append(constancy_against(own, sure_growth(baseline_rows(comparison, baseline), BYTES), bound))
        if smaller := crossings(comparison, baseline):
            clauses.append(f" {baseline.name} is the smaller one below " + ", ".join(f"{count_text(h)} hits ({s})" for s, h in smaller.items()) + ".")
            below = f"is the smaller map below {range_text([h / 1e6 for h in smaller.values()])} M hits"
            conditions.append(f"{baseline.name} {below}")
            plain.append(sentence(f"{baseline.plain_name} {below}"))
    return Finding("constant-memory", says, own,
                   f"Bytes of the map, {hits_range(rows)}: largest over smallest {listing(spreads, '{:.4f}')}; MiB: {listing(sizes, '{:.1f}')}, "
                   f"while they are filled {listing(working, '{:.1f}')}." + "".join(clauses) + peak_text(comparison), *verdicts,
                   condition="; ".join(conditions), plain=" ".join(plain), figure=f"{range_text(sizes.values(), '{:.1f}')} MiB, {hits_range(rows)}", scenes=tuple(spreads), runs=runs_of(rows))


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
    if not all(has_enough_runs(comparison.row(scene, comparison.light_map, MANY)) for scene in spreads):
        return NOT_DECIDED, f"1e9 hits against 1e5: too few runs, {listing(spreads, '{:.3f}')}"
    either_way = {scene: max(ratio, 1 / ratio) for scene, ratio in spreads.items()}
    verdict = verdict_by_spread(either_way, sure, SAME_TIME)
    return verdict, f"1e9 hits against 1e5 (within 5 %): {verdict}, {listing(spreads, '{:.3f}')}"


def constant_gather(comparison, study=None):
    says, bound = "Search time does not depend on the photon count", 1.15
    all_rows = light_map_rows(comparison)
    if not spread_over_hits(all_rows, GATHER_US):
        return Finding("constant-gather", says, NOT_MEASURED_YET, "needs shlm at two numbers of hits")
    rows, lacking = sizes_in_all(all_rows)
    spreads, sure = spread_over_hits(rows, GATHER_US), sure_spread(rows, GATHER_US)
    billion, billion_text = same_at_a_billion(comparison)
    own = verdict_by_spread(spreads, sure, bound)
    own = own if billion in (NOT_MEASURED, own) else min(own, billion, key=("refuted", "conditional", NOT_DECIDED, "confirmed").index)
    verdicts, clauses = [], []
    for baseline in (incremental(comparison), strongest(comparison, GATHER_US, is_as_accurate(comparison, study))):
        theirs, _ = sizes_in_all(baseline_rows(comparison, baseline))
        verdicts.append(constancy_against(own, sure_growth(theirs, GATHER_US), bound))
        clauses.append(f"{baseline.name} {listing(spread_over_hits(theirs, GATHER_US))}")
    plain = why_not_decided(lacking) if own == NOT_DECIDED else ""
    if own == "conditional" and spreads:
        plain = f"Beyond what the runs of a size differ by, sizes differ by up to {max(sure.values()):.2f} times."
    return Finding("constant-gather", says, own,
                   f"Slowest over fastest median over {hits_range(rows_of(comparison, comparison.light_map))}: {listing(spreads)}; "
                   f"beyond the noise (bound {bound}): {listing(sure)}; {billion_text}. Photon maps: {'; '.join(clauses)}.", *verdicts,
                   condition=lacking_text(lacking), plain=plain, figure=f"spread {range_text(spreads.values())}" if spreads else "",
                   scenes=tuple(spreads or all_rows), runs=runs_of([row for series in (rows if spreads else all_rows).values() for row in series]))


def measured_here(comparison, study=None):
    """The claims that a comparison alone can measure."""
    return [
        tracing_speed(comparison),
        constant_insert(comparison),
        constant_memory(comparison),
        constant_gather(comparison, study),
        faster_gather(comparison, study),
        billion_hits(comparison),
    ]


def measured_by_study(study, light_map):
    if not study:
        return [not_measured(*NORMAL_MAPS), not_measured(*CONVERGES)]
    return [normal_maps(study, light_map), converges(study, light_map)]


def findings(comparison, study):
    """Of the comparison's light map. `study`: the summary.json of a study, None without one."""
    return measured_here(comparison, study) + measured_by_study(study, comparison.light_map)
