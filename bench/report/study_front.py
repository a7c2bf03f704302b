"""The Pareto front: measured runs that no other run beats in both cost and error."""


def pareto_front(points, cost_of):
    """In ascending order of cost. `points` have split.error; of two equal ones the first is kept."""
    front = []
    for point in sorted(points, key=lambda p: (cost_of(p), p.split.error)):
        if point.split.error > 0 and (not front or point.split.error < front[-1].split.error):
            front.append(point)
    return front


def all_points(curves):
    """`curves`: name -> Curve"""
    return [point for curve in curves.values() for point in curve.points]
