"""From where on chance may end Mitsuba's paths. A variant must be set before this module is imported."""

import numpy as np

from images import linear_texels

_FEWEST, _MOST = 5, 200
_LEFT = 0.1


def roulette_depth(scene):
    """Bounces after which a tenth of a path's light is left where surfaces have the scene's mean albedo.

    Mitsuba ends a path with a chance of 5 % at least. Among white walls that begins to be a matter of luck long before the light has
    died out: with its own start, after five bounces, the variance has no bound at albedos above 0.975."""
    albedo = _mean_albedo(scene)
    if not 0 < albedo < 1:
        return _MOST if albedo >= 1 else _FEWEST
    return int(np.clip(np.ceil(np.log(_LEFT) / np.log(albedo)), _FEWEST, _MOST))


def _mean_albedo(scene):
    """Over the area of all surfaces, of the brightest channel."""
    areas = [_area(mesh) for mesh in scene.meshes]
    albedos = [np.max(_mean_color(mesh)) for mesh in scene.meshes]
    return float(np.dot(areas, albedos) / max(np.sum(areas), 1e-300))


def _area(mesh):
    a, b, c = (mesh.position[mesh.triangles[:, i]].astype(float) for i in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def _mean_color(mesh):
    color = np.array(mesh.material.base_color)
    if mesh.material.base_color_texture:
        color = color * linear_texels(mesh.material.base_color_texture.image)[..., :3].mean(axis=(0, 1))
    return color if mesh.color is None else color * mesh.color[:, :3].mean(axis=0)
