"""The Pareto front: what nobody beats in both cost and error."""


def front_of(items, cost_of, error_of, least_gain=0.0):
    """In ascending order of cost; of two equal ones the first is kept. Each is better than the one before by more than
    `least_gain`, a share of its error."""
    front = []
    for item in sorted(items, key=lambda i: (cost_of(i), error_of(i))):
        if not front or error_of(item) < (1 - least_gain) * error_of(front[-1]):
            front.append(item)
    return front
