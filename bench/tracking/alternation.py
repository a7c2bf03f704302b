"""Two programs by turns, so that what changes slowly on the machine meets both alike."""

LEAST_PAIRS = 10


def order(pairs):
    """ABBA ABBA ...: each pair begins with the program that the last one ended with."""
    return [(0, 1) if pair % 2 == 0 else (1, 0) for pair in range(pairs)]


def alternate(measure, two, pairs):
    """Two lists, `pairs` values long: measure(two[0]) and measure(two[1]) of each pair."""
    values = ([], [])
    for turns in order(pairs):
        for which in turns:
            values[which].append(measure(two[which]))
    return values
