"""The Pareto front of measured runs."""

from report.front import front_of


def pareto_front(points, cost_of):
    """Of measured runs. `points` have split.error, which the reference's own error may take below zero."""
    return front_of([p for p in points if p.split.error > 0], cost_of, lambda p: p.split.error)


def all_points(curves):
    """`curves`: name -> Curve"""
    return [point for curve in curves.values() for point in curve.points]
