"""What is derived from the curves of one scene, for report, charts and summary.json alike."""

from dataclasses import dataclass

from report.study.crossings import Less, more_accurate_at_equal, more_accurate_at_equal_bytes, smaller_at_equal_hits
from report.study.front import all_points, pareto_front
from report.study.methods import LIGHT_MAP, OTHER, REFERENCE_LIGHT_MAP, REFERENCE_PHOTON_MAP
from report.study.slopes import slope_finding
from report.study.targets import TARGETS, bytes_to_reach, time_to_reach


@dataclass(frozen=True)
class Crossing:
    """Where the reference light map is more accurate than one photon map."""

    hits: Less
    seconds: Less
    bytes: Less  # in hits of the light map


@dataclass(frozen=True)
class SceneFindings:
    slopes: dict  # method -> SlopeFinding
    times: dict  # target -> method -> Reach
    bytes: dict  # the same
    front_by_time: list  # of Point
    front_by_bytes: list
    crossings: dict  # photon map -> Crossing; empty without the reference light map
    smaller: Less  # reference light map than reference photon map, by hits; None where one is missing
    texels: int  # of the reference light map


def crossings(curves):
    mine = curves.get(REFERENCE_LIGHT_MAP)
    if mine is None:
        return {}
    return {
        name: Crossing(
            more_accurate_at_equal("hits", mine, other),
            more_accurate_at_equal("seconds", mine, other),
            more_accurate_at_equal_bytes(mine, other),
        )
        for name, other in curves.items()
        if other.method.family not in (LIGHT_MAP, OTHER)
    }


def findings_of(curves):
    """`curves`: method -> Curve"""
    mine, photons = curves.get(REFERENCE_LIGHT_MAP), curves.get(REFERENCE_PHOTON_MAP)
    return SceneFindings(
        slopes={name: slope_finding(c) for name, c in curves.items()},
        times={target: {name: time_to_reach(c, target) for name, c in curves.items()} for target in TARGETS},
        bytes={target: {name: bytes_to_reach(c, target) for name, c in curves.items()} for target in TARGETS},
        front_by_time=pareto_front(all_points(curves), lambda p: p.seconds),
        front_by_bytes=pareto_front(all_points(curves), lambda p: p.bytes),
        crossings=crossings(curves),
        smaller=smaller_at_equal_hits(mine, photons) if mine and photons else None,
        texels=mine.texels if mine else 0,
    )
