"""What a chart shows beside its points: the Pareto front, and the slope that theory gives the noise."""

from report.front import front_of
from report.page.quantities import COSTS, ERRORS
from report.study.methods import SLOPE_OF_THEORY


def front(rows, cost, error):
    """Numbers of the rows that no other beats in both. What is lost in the noise does not compete."""
    drawn = [row for row in rows if cost.of(row) is not None and error.of(row)]
    return [row.number for row in front_of(drawn, cost.of, error.of)]


def fronts(study):
    """cost/error -> scene -> numbers of rows"""
    by_scene = {scene: [row for row in study.rows if row.scene == scene] for scene in study.scenes}
    return {
        f"{cost.key}/{error.key}": {scene: front(rows, cost, error) for scene, rows in by_scene.items()}
        for cost in COSTS
        for error in ERRORS
    }


def ghost(rows, cost, slope):
    """Two ends (cost, noise) of a line of this slope over the hits through the noise of the largest run. Time is taken to grow
    as the hits do, as it does once there are many."""
    last, first = rows[-1], rows[0]
    if not last.noise or len(rows) < 2 or not first.hits < last.hits:
        return None
    factor = last.hits / first.hits
    return [[cost.of(last) / factor, last.noise * factor**-slope], [cost.of(last), last.noise]]


def ghosts(study, scene):
    """hits, seconds -> [{method, slope, line}]: noise alone, whose square theory says all about. Of the best of each kind the first with each slope."""
    made = {}
    for cost in (c for c in COSTS if c.key in ("seconds", "hits")):
        made[cost.key] = []
        for name in study.best_known:
            family = study.kinds[name].method.family
            if any(g["slope"] == SLOPE_OF_THEORY.get(family, 0) / 2 for g in made[cost.key]):
                continue
            rows = sorted((r for r in study.rows if r.scene == scene and r.method == name), key=lambda r: r.hits)
            if family in SLOPE_OF_THEORY and rows and (line := ghost(rows, cost, SLOPE_OF_THEORY[family] / 2)):
                made[cost.key].append({"method": name, "slope": SLOPE_OF_THEORY[family] / 2, "line": line})
    return made
