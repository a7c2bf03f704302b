"""A scene between the file and Mitsuba: world-space meshes, materials and lights."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class TextureUse:
    """An sRGB image (encoded bytes, row 0 at v = 0) and how it is looked up."""

    image: bytes
    texcoord_set: int
    wrap: str


@dataclass(frozen=True)
class Material:
    name: str = "default"
    kind: str = "diffuse"  # or "mirror", "glass"
    base_color: tuple = (1.0, 1.0, 1.0)  # albedo, reflectance of a mirror, tint of glass
    base_color_texture: TextureUse | None = None
    emitted_radiance: tuple = (0.0, 0.0, 0.0)  # W/(m^2 sr), from the front face
    emissive_texture: TextureUse | None = None
    index_of_refraction: float = 1.5

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
class Scene:
    meshes: list
    point_lights: list
    spot_lights: list
