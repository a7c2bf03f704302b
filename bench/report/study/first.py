"""Who reaches an error first: the light map and the photon map that take least time, chosen in hindsight, and their bytes."""

from report.study.methods import label_of
from report.study.targets import TARGETS, winners
from report.text import NOTHING, bytes_text, percent_text, seconds_text


def is_photon_map(curve):
    return curve.method.engine != ""


def of_kind(curves, photon_maps):
    return {name: curve for name, curve in curves.items() if is_photon_map(curve) == photon_maps}


def fastest(curves, reaches):
    """Of these curves the name that reaches the target in least time; None where nobody does."""
    return next(iter(winners({name: reaches[name] for name in curves})), None)


def nearest(curves):
    """The point with the least error."""
    return min((point for curve in curves.values() for point in curve.points), key=lambda p: p.split.error, default=None)


def reached_text(name, seconds, size):
    return f"{seconds_text(seconds)}, {bytes_text(size)} ({label_of(name)})"


def nearest_text(point):
    if point is None:
        return NOTHING
    return f"nobody; nearest {percent_text(point.split.error)}: {reached_text(point.run.method, point.seconds, point.bytes)}"


def side(curves, found, target):
    """(what a cell says, seconds, bytes): the last two None where nobody reaches the target."""
    name = fastest(curves, found.times[target])
    if name is None:
        return nearest_text(nearest(curves)), None, None
    seconds, size = found.times[target][name].cost, found.bytes[target][name].cost
    return reached_text(name, seconds, size), seconds, size


def times_text(ratio):
    """Two digits: 0.84 x, 12 x, 310 x."""
    return f"{float(f'{ratio:.2g}'):g} x"


def ratio_text(light, photons):
    """Photon map over light map: time, bytes."""
    if None in light[1:] or None in photons[1:]:
        return NOTHING
    return ", ".join(times_text(theirs / mine) for mine, theirs in zip(light[1:], photons[1:]))


def rows_of_scene(scene, curves, found):
    kinds = [of_kind(curves, photon_maps) for photon_maps in (False, True)]
    for target in TARGETS:
        light, photons = (side(kind, found, target) for kind in kinds)
        if light[1] is not None or photons[1] is not None or target == TARGETS[0]:
            yield [scene, f"{100 * target:g} %", light[0], photons[0], ratio_text(light, photons)]


def first_rows(curves_by_scene, findings):
    return [row for scene, curves in curves_by_scene.items() for row in rows_of_scene(scene, curves, findings[scene])]
