"""What is asked of the methods on a scene that nobody here made."""

from dataclasses import dataclass

from report.elsewhere.figures import LARGEST_Z, MISSED, PASSED, UNDECIDED, Error

MEAN_BOUND, REGION_BOUND, PHOTON_MAP_BOUND = 0.01, 0.02, 0.02
LIGHT_MAP, PHOTON_MAP = "shlm", "photonmap"  # as the list of methods has them: the defaults


@dataclass(frozen=True)
class Bound:
    text: str
    bound: float
    error: Error | None
    verdict: str

    @property
    def is_missed(self):
        return self.verdict == MISSED


def bounds_of(figures_by_method):
    """`figures_by_method`: of the largest number of hits, by the names of the list of methods."""
    light_map, photon_map = figures_by_method.get(LIGHT_MAP), figures_by_method.get(PHOTON_MAP)
    found = []
    if light_map:
        found.append(_bound("light map, mean", MEAN_BOUND, light_map.mean))
        found.append(_region_bound(light_map))
    if photon_map:
        found.append(_bound("photon map, mean", PHOTON_MAP_BOUND, photon_map.mean))
    return found


def verdict_of(bounds):
    """The worst of them."""
    verdicts = [bound.verdict for bound in bounds]
    return next((v for v in (MISSED, UNDECIDED) if v in verdicts), PASSED)


def _bound(text, bound, error, largest_z=LARGEST_Z):
    return Bound(text, bound, error, error.judged(bound, largest_z))


def _region_bound(figures):
    text = "light map, every filled region"
    if figures.worst_region is None:
        return Bound(text, REGION_BOUND, None, "no region is filled")
    surest = _bound(text, REGION_BOUND, figures.surest_region, figures.region_z)
    return surest if surest.is_missed else _bound(text, REGION_BOUND, figures.worst_region, figures.region_z)
