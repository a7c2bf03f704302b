"""Colours, markers and lines of the methods of a study, shaded where a chart has many of a kind."""

import matplotlib
import numpy as np
from matplotlib.colors import to_rgb

from report.study.methods import FIXED_K, FIXED_RADIUS, GROWING_K, LIGHT_MAP

MAPS = {
    FIXED_K: ("Blues", 0.55, 0.95),
    GROWING_K: ("Greens", 0.55, 0.9),
    FIXED_RADIUS: ("Purples", 0.55, 0.9),
}
WEIGHT_BLENDS = {"radiance": ("#000000", 0.0), "normalised": ("#000000", 0.4), "flux": ("#ffffff", 0.5)}  # towards which, how far
GATHER_DASHES = {"own": (0, (1, 1.2)), "bilinear": (0, (4, 1.5)), "surface4": "-", "knn4": (0, (6, 1, 1, 1))}
OTHER_GATHER = (0, (6, 1.5, 1, 1.5))
KERNEL_DASHES = {"cone": (0, (4, 1.5)), "epanechnikov": (0, (1, 1.2))}
GATHER_MARKERS = {"surface4": "^", "knn4": "<", "own": "v", "bilinear": "D"}
OTHER_GATHER_MARKER = "*"
PLACEMENT_FILLS = {"": "full", "uv": "left", "face": "right"}
FAMILY_MARKERS = {FIXED_K: "o", GROWING_K: "s", FIXED_RADIUS: "p"}


def colour_of_weight(colour, weight):
    """The basis's own for the radiance weight, darker where it is normalised, paler for flux."""
    towards, share = WEIGHT_BLENDS[weight]
    return tuple((1 - share) * np.array(to_rgb(colour)) + share * np.array(to_rgb(towards)))


class Styles:
    """Of all methods of a study: within a kind of photon map the colour darkens with k, C or the radius."""

    def __init__(self, methods):
        self._numbers = {f: sorted({m.number for m in methods if m.family == f}) for f in MAPS}
        self._texels = sorted({m.texels for m in methods if m.family == LIGHT_MAP and m.texels})

    def _shade(self, method):
        name, first, last = MAPS[method.family]
        numbers = self._numbers[method.family]
        along = numbers.index(method.number) / max(1, len(numbers) - 1)
        return matplotlib.colormaps[name](first + (last - first) * along)

    def of(self, method):
        """Keyword arguments of plot."""
        if method.family == LIGHT_MAP:
            colour = colour_of_weight(method.colour, method.weight)
            if method.texels:
                share = (self._texels.index(method.texels) + 1) / (len(self._texels) + 1)
                colour = matplotlib.colormaps["copper"](0.25 + 0.7 * share)
            dashes = GATHER_DASHES.get(method.gather, OTHER_GATHER)
            return {
                "color": colour,
                "marker": GATHER_MARKERS.get(method.gather, OTHER_GATHER_MARKER),
                "fillstyle": PLACEMENT_FILLS[method.placement],
                "linestyle": dashes,
            }
        if method.family in MAPS:
            return {
                "color": self._shade(method),
                "marker": FAMILY_MARKERS[method.family],
                "linestyle": KERNEL_DASHES.get(method.kernel, "-"),
            }
        return {"color": method.colour, "marker": method.marker, "linestyle": "-"}
