"""What a method of a study is, as its rows say it, and what theory says of it.

Theory, for N hits. A light map's texel and a disc of fixed radius average a number of hits that grows as N
over an area that stays: variance ~ 1/N, bias fixed (the floor). The k nearest photons with fixed k: variance
fixed, bias falls with the disc. k = C N^(2/3): variance ~ 1/k, area ~ k/N, squared bias ~ area^2 in smooth
light, both ~ N^(-2/3).
"""

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

REFERENCE_LIGHT_MAP = "shlm/L2/radiance/surface4"  # what "shlm" stands for
TRADITIONAL_LIGHT_MAP = "shlm/L0/normalised/surface4"
REFERENCE_PHOTON_MAP = "photonmap/compact/k50/disc"  # of the engine that is fastest and smallest


def label_of(name):
    """In charts, where room is scarce: the engine goes without saying."""
    return name.replace("photonmap/compact/", "photonmap/")


NO_STYLE = {"colour": "#666666", "marker": "x"}


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
    number: float = 0  # k, C, the radius as a share of the scene's diagonal, or the error in % that an adaptive map wants
    kernel: str = ""
    basis: str = ""
    half: bool = False  # stores 16-bit floats
    engine: str = ""
    colour: str = NO_STYLE["colour"]
    marker: str = NO_STYLE["marker"]

    @property
    def label(self):
        return label_of(self.name)

    @property
    def has_floor(self):
        """Its bias stays whatever the hits, and only its variance falls; of light maps once texels show their own hits."""
        return self.family in (LIGHT_MAP, FIXED_RADIUS)


PHOTON_SELECTIONS = {"nearest": FIXED_K, "growing_factor": GROWING_K, "diagonal_fraction": FIXED_RADIUS}


def method_of(row):
    """Of a row of results. What has no fields, or is an adaptive map, is a method like any other, of which theory says nothing."""
    fields = row.get("fields", {})
    style = row.get("style", NO_STYLE)
    drawn = {"colour": style["colour"], "marker": style["marker"]}
    if fields.get("family") == "shlm":
        adaptive = "wanted_error_percent" in fields
        return Method(
            row["method"],
            OTHER if adaptive else LIGHT_MAP,
            order=fields["summed_order"],
            weight=fields["weight"],
            gather=fields["gather"],
            placement=fields.get("placement", ""),
            texels=fields.get("texels", 0),
            least_hits=fields.get("least_hits", 0),
            number=fields.get("wanted_error_percent", 0),
            basis=fields["basis"],
            half=fields.get("half", False),
            **drawn,
        )
    if fields.get("family") == "photonmap":
        key = next(k for k in PHOTON_SELECTIONS if k in fields)
        return Method(
            row["method"], PHOTON_SELECTIONS[key], number=float(fields[key]), kernel=fields["kernel"], engine=fields["engine"], **drawn
        )
    return Method(row["method"], OTHER)
