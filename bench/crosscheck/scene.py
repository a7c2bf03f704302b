"""A scene between the file and Mitsuba: world-space meshes, materials and lights."""

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class TextureUse:
    """An sRGB image (encoded bytes, row 0 at v = 0), perhaps with alpha, and how it is looked up."""

    image: bytes
    texcoord_set: int = 0
    wrap: tuple = ("repeat", "repeat")  # along u and v: "repeat", "clamp" or "mirror"
    to_uv: tuple | None = None  # rows of a 3 x 3 matrix that the coordinates are multiplied by first


@dataclass(frozen=True)
class Material:
    name: str = "default"
    kind: str = "diffuse"  # or "mirror", "glass" (the boundary of a body), "sheet" (glass without thickness)
    base_color: tuple = (1.0, 1.0, 1.0)  # albedo, reflectance of a mirror, tint of glass
    base_color_texture: TextureUse | None = None
    emitted_radiance: tuple = (0.0, 0.0, 0.0)  # W/(m^2 sr)
    emissive_texture: TextureUse | None = None
    index_of_refraction: float = 1.5
    double_sided: bool = False  # both faces emit, else the front alone
    alpha_mode: str = "OPAQUE"  # or "MASK", "BLEND"
    alpha: float = 1.0  # times that of the base colour's texture and of the vertices
    alpha_cutoff: float = 0.5

    @property
    def emits(self):
        return max(self.emitted_radiance) > 0


@dataclass(frozen=True)
class Mesh:
    """Triangles, counter-clockwise seen from the front."""

    material: Material
    position: np.ndarray  # (vertices, 3) float32, world space
    triangles: np.ndarray  # (triangles, 3) uint32
    normal: np.ndarray | None = None  # (vertices, 3), unit
    texcoord: tuple = (None, None)  # (vertices, 2) each
    color: np.ndarray | None = None  # (vertices, 4), linear, in [0, 1]: multiplies base colour and alpha


@dataclass(frozen=True)
class PointLight:
    position: tuple
    intensity: tuple  # W/sr


@dataclass(frozen=True)
class SpotLight:
    position: tuple
    axis: tuple  # unit, the way the light shines
    intensity: tuple  # W/sr on the axis
    inner_angle: float  # radians from the axis
    outer_angle: float


@dataclass(frozen=True)
class DirectionalLight:
    direction: tuple  # unit, the way the light travels
    irradiance: tuple  # W/m^2 on a surface perpendicular to it


@dataclass(frozen=True)
class Scene:
    meshes: list
    point_lights: list = field(default_factory=list)
    spot_lights: list = field(default_factory=list)
    directional_lights: list = field(default_factory=list)
    sky_radiance: tuple = (0.0, 0.0, 0.0)  # W/(m^2 sr), the same from everywhere outside
    left_out: list = field(default_factory=list)  # what the file asks for beside this, in words

    @property
    def lights_without_area(self):
        return [*self.point_lights, *self.spot_lights, *self.directional_lights]
