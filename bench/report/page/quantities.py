"""What the charts can show over what: values, limits and ticks of the eight axes. All are logarithmic."""

from dataclasses import dataclass
from typing import Callable

from report.page.rows import StudyRows
from report.text import bytes_text, hits_text, number_text, seconds_text


@dataclass(frozen=True)
class Quantity:
    key: str
    label: str  # on the axis
    short: str  # in menus
    of: Callable  # of a Row; None where it was not measured
    text: Callable
    ticks: tuple  # sets of them, the coarsest first
    band: Callable = lambda row: None


def percent_text(value):
    return f"{number_text(value)}\u00a0%"


ONE_TWO_FIVE = (tuple(m * 10.0**p for p in range(-6, 13) for m in (1, 2, 5)),)
DECADES = (tuple(10.0**p for p in range(-6, 13)), *ONE_TWO_FIVE)
BINARY = tuple(tuple(2.0 ** (step * p) for p in range(50 // step)) for step in (5, 2, 1))  # 1 KiB, 32 KiB, 1 MiB, ...; 1, 4, 16 KiB; 1, 2, 4 KiB
LEAST_TICKS = 3

COSTS = (
    Quantity("seconds", "time until every point is answered", "time", lambda r: r.seconds, seconds_text, DECADES),
    Quantity("bytes", "bytes of the finished map", "finished bytes", lambda r: r.bytes, bytes_text, BINARY),
    Quantity("working", "bytes while the map is filled", "working bytes", lambda r: r.working, bytes_text, BINARY),
    Quantity("hits", "hits", "hits", lambda r: r.hits, hits_text, DECADES),
)
ERRORS = (
    Quantity("error", "error, relative RMS", "error", lambda r: r.error, percent_text, ONE_TWO_FIVE, lambda r: r.error_band),
    Quantity("bias", "bias, relative RMS", "bias", lambda r: r.bias, percent_text, ONE_TWO_FIVE, lambda r: r.bias_band),
    Quantity("noise", "noise (standard deviation), relative RMS", "noise", lambda r: r.noise, percent_text, ONE_TWO_FIVE, lambda r: r.noise_band),
    Quantity("flip", "HDR-FLIP of the first seed's picture", "FLIP", lambda r: r.flip, number_text, ONE_TWO_FIVE),
)
MARGIN = 1.3  # factor beyond the outermost values


def least_shown(study: StudyRows):
    """Errors far below the references' own are of no interest: they lie on the lower edge."""
    return 0.3 * min(study.reference_error(scene) for scene in study.scenes) or 1e-3


def limits_of(quantity, study):
    """The same for all scenes."""
    floor = least_shown(study) if quantity.key in ("error", "bias", "noise") else 0.0
    values = [max(value, floor) for row in study.rows if (value := quantity.of(row)) is not None and value > 0]
    return (min(values) / MARGIN, max(values) * MARGIN) if values else (0.1, 10.0)


class Scales:
    """Limits of all axes of one study, and where a value lies in a panel. Pixels are those of the panel's viewBox, y downwards."""

    WIDTH, HEIGHT = 470, 320
    LEFT, RIGHT, TOP, BOTTOM = 70, 14, 10, 46

    def __init__(self, study):
        self.limits = {q.key: limits_of(q, study) for q in (*COSTS, *ERRORS)}

    def ticks(self, quantity):
        """The coarsest set that has a few within the limits."""
        low, high = self.limits[quantity.key]
        sets = [[t for t in ticks if low <= t <= high] for ticks in quantity.ticks]
        return next((ticks for ticks in sets if len(ticks) >= LEAST_TICKS), sets[-1])

    def clamped(self, quantity, value):
        low, high = self.limits[quantity.key]
        return min(max(value, low), high)
