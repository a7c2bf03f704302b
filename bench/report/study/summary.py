"""All derived figures as one JSON document; what could not be computed is null."""

import math

from report.study.bootstrap import CONFIDENCE, RANDOM_SEED, RESAMPLES
from report.study.data import EPSILON_SHARE, PHASES
from report.study.slopes import FIRST_HITS, VARIANCE_OVER_BIAS
from report.study.text import METRIC


def plain(value):
    """Numbers that are not finite become null; tuples become lists."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {str(key): plain(v) for key, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    return value


def split_entry(split):
    return {
        "seeds": split.seed_count,
        "mse": split.mse,
        "error": split.error,
        "error_band": split.error_band,
        "bias_sq": split.bias_sq,
        "bias_sq_band": split.bias_sq_band,
        "variance": split.variance,
        "variance_band": split.variance_band,
    }


def point_entry(point):
    run = point.run
    optional = {
        c: run.median(c)
        for c in ("prepare_seconds", "prepare_bytes", "insert_bytes", "hits_rejected", "clamped_share")
        if run.has(c)
    }
    return {
        "hits_asked": run.hits_asked,
        "hits": point.hits,
        **split_entry(point.split),
        **{phase + "_seconds": run.median(phase + "_seconds") for phase in PHASES},
        "total_seconds": point.seconds,
        "bytes": point.bytes,
        **({} if run.flip is None else {"flip_of_first_seed": run.flip}),
        **optional,
        "tilt": [
            {"degrees": [t.low, t.high], "points": t.points, **split_entry(t.split)} for t in point.tilted
        ],
    }


def slope_entry(finding):
    def entry(slope):
        return slope and {"value": slope.value, "band": slope.band, "sizes": slope.sizes}

    return {
        "error": entry(finding.error),
        "variance": entry(finding.variance),
        "error_over_seconds": entry(finding.over_seconds),
        "error_over_bytes": entry(finding.over_bytes),
        "theory": finding.theory,
        "verdict": finding.verdict,
    }


def reach_entries(reaches_by_target):
    return {
        f"{target:g}": {name: {"kind": r.kind, "cost": r.cost, "band": r.band} for name, r in reaches.items()}
        for target, reaches in reaches_by_target.items()
    }


def less_entry(less):
    return less and {
        "intervals": less.intervals,
        "range": less.range,
        "crossing": less.crossing,
        "band": less.band,
    }


def front_entry(front):
    return [[p.run.method, p.run.hits_asked] for p in front]


def scene_entry(scene, curves, found):
    return {
        "points": scene.points,
        "epsilon": scene.epsilon,
        "reference_error_sq": scene.reference_error_sq,
        "methods": {name: [point_entry(p) for p in c.points] for name, c in curves.items()},
        "slopes": {name: slope_entry(f) for name, f in found.slopes.items()},
        "seconds_to_reach": reach_entries(found.times),
        "bytes_to_reach": reach_entries(found.bytes),
        "front_by_time": front_entry(found.front_by_time),
        "front_by_bytes": front_entry(found.front_by_bytes),
        "more_accurate_than": {
            name: {
                "hits": less_entry(c.hits),
                "seconds": less_entry(c.seconds),
                "hits_at_equal_bytes": less_entry(c.bytes),
            }
            for name, c in found.crossings.items()
        },
        "smaller_than_reference_photon_map": less_entry(found.smaller),
    }


def summary(study, curves_by_scene, findings, groups):
    return plain(
        {
            "context": study.context,
            "definitions": {
                "metric": METRIC,
                "epsilon_share": EPSILON_SHARE,
                "confidence": CONFIDENCE,
                "resamples": RESAMPLES,
                "random_seed": RANDOM_SEED,
                "fit_variance_over_bias": VARIANCE_OVER_BIAS,
                "fit_first_hits": FIRST_HITS,
            },
            "groups": groups,
            "scenes": {
                name: scene_entry(study.scenes[name], curves, findings[name])
                for name, curves in curves_by_scene.items()
            },
            "problems": study.problems,
        }
    )
