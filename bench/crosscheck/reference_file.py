"""What `shlmbench reference` has written, read back."""

from dataclasses import dataclass

import drjit as dr
import mitsuba as mi
import numpy as np

from input_error import InputError
from irradiance import Estimate
from points import Points, mean_at

_REGION_SIZE = 8  # pixels


@dataclass(frozen=True)
class Reference:
    points: Points
    estimate: Estimate
    region_of: np.ndarray  # (points,): the square of 8 x 8 pixels that a point is seen in
    notes: dict  # how the file was made, as it says itself


def read_reference(file):
    """The pixels of FILE (.exr) that see a surface. Raises InputError for anything else than a reference."""
    try:
        bitmap = mi.Bitmap(str(file))
    except RuntimeError as error:
        raise InputError(f"{file}: cannot be read as OpenEXR") from error
    image = np.array(bitmap, dtype=np.float64)
    columns = {field.name: i for i, field in enumerate(bitmap.struct_())}
    needed = ("A", "irradiance.R", "variance.R", "position.X", "normal.X", "geometric_normal.X")
    missing = [name for name in needed if name not in columns]
    if missing:
        raise InputError(f"{file}: not a reference: the channel {missing[0]} is missing")
    seen = image[..., columns["A"]] == 1
    if not seen.any():
        raise InputError(f"{file}: no pixel sees a surface")

    def channels(name, letters):
        return image[..., [columns[f"{name}.{letter}"] for letter in letters]][seen]

    points = Points(channels("position", "XYZ"), channels("normal", "XYZ"), channels("geometric_normal", "XYZ"))
    notes = {key: bitmap.metadata()[key] for key in bitmap.metadata().keys() if key.startswith("shlmbench:")}
    estimate = Estimate(channels("irradiance", "RGB"), channels("variance", "RGB"))
    return Reference(points, estimate, _region_of(seen), notes)


def _region_of(seen):
    """Numbers of the squares for the pixels that are seen, row by row."""
    y, x = np.nonzero(seen)
    return y // _REGION_SIZE * -(-seen.shape[1] // _REGION_SIZE) + x // _REGION_SIZE


def check_points_lie_on(scene, reference, name):
    """Raises InputError where the points are not on the surfaces of `scene`, a mi.Scene."""
    extent = np.array(scene.bbox().max) - np.array(scene.bbox().min)
    height = 1e-4 * float(np.linalg.norm(extent))

    def is_off(position, _, normal):
        below = scene.ray_intersect(mi.Ray3f(position + height * normal, -normal))
        is_near = (below.t < 1.5 * height) & (dr.abs(dr.dot(below.n, normal)) > 0.99)
        return mi.Color3f(dr.select(is_near, mi.Float(0), mi.Float(1)))

    # Not each of them: in a corner another surface may be nearer.
    if mean_at(reference.points.every(16), 1, is_off).mean() > 0.05:
        raise InputError(f"{name}: its points do not lie on the scene's surfaces")
