"""What the name of a method in a study says, and what theory says of it.

Theory, for N hits. A light map's texel and a disc of fixed radius average a number of hits that grows as N
over an area that stays: variance ~ 1/N, bias fixed (the floor). The k nearest photons with fixed k: variance
fixed, bias falls with the disc. k = C N^(2/3): variance ~ 1/k, area ~ k/N, squared bias ~ area^2 in smooth
light, both ~ N^(-2/3).
"""

import re
from dataclasses import dataclass

LIGHT_MAP = "shlm"
FIXED_K = "k"
GROWING_K = "kCn23"
FIXED_RADIUS = "r"
OTHER = "other"

SLOPE_OF_THEORY = {LIGHT_MAP: -1.0, FIXED_RADIUS: -1.0, GROWING_K: -2.0 / 3.0, FIXED_K: 0.0}
THEORY_TEXT = {
    LIGHT_MAP: "-1 until the floor",
    FIXED_RADIUS: "-1 until the floor",
    GROWING_K: "-2/3",
    FIXED_K: "0",
}

SUMMED_ORDER = {"L0": 0, "L1": 1, "L2": 2, "L4": 4, "H4": 2, "H6": 2, "YH4": 2, "YL2": 2, "AD": 1}
DEFAULT_LEAST_HITS = 100  # shlm/settings.h

REFERENCE_LIGHT_MAP = "shlm/L2/radiance/surface4"  # what "shlm" stands for
TRADITIONAL_LIGHT_MAP = "shlm/L0/normalised/surface4"
REFERENCE_PHOTON_MAP = "photonmap/flann/k50/disc"


@dataclass(frozen=True)
class Method:
    name: str
    family: str
    order: int = 0  # of the spherical harmonics that are summed
    weight: str = ""  # what a hit stands for: radiance, flux, normalised
    gather: str = ""  # own, bilinear, surface4, knn4, ...
    placement: str = ""  # uv or face; empty: the study's default
    texels: int = 0  # 0: the study's default
    least_hits: int = 0  # texels in blocks of fewer hits share their light
    number: float = 0  # k, C or the radius as a share of the scene's diagonal
    kernel: str = ""

    @property
    def label(self):
        return self.name.replace("photonmap/flann/", "photonmap/")

    @property
    def has_floor(self):
        """Its bias stays whatever the hits, and only its variance falls; of light maps once texels show their own hits."""
        return self.family in (LIGHT_MAP, FIXED_RADIUS)


def parse_light_map(name):
    parts = re.fullmatch(r"shlm/(\w+)/(\w+)/(\w+)(?:/(uv|face))?(?:/t(\d+))?(?:/h(\d+))?(?:/half)?", name)
    if not parts or parts[1] not in SUMMED_ORDER:
        return None
    basis, weight, gather, placement, texels, least_hits = parts.groups()
    return Method(
        name,
        LIGHT_MAP,
        order=SUMMED_ORDER[basis],
        weight=weight,
        gather=gather,
        placement=placement or "",
        texels=int(texels or 0),
        least_hits=DEFAULT_LEAST_HITS if least_hits is None else int(least_hits),
    )


def parse_photon_map(name):
    parts = re.fullmatch(r"photonmap/\w+/([kr])([0-9.eE+-]+?)(n23)?/(\w+)", name)
    if not parts:
        return None
    letter, number, grows, kernel = parts.groups()
    family = FIXED_RADIUS if letter == "r" else GROWING_K if grows else FIXED_K
    return Method(name, family, number=float(number), kernel=kernel)


def parse(name):
    """A name of another form is a method like any other, of which theory says nothing."""
    return parse_light_map(name) or parse_photon_map(name) or Method(name, OTHER)
