"""Small scenes for the self-test, and how exact an estimate of theirs must be."""

from statistics import NormalDist

import mitsuba as mi
import numpy as np

from irradiance import Method, estimate_irradiance
from mitsuba_scene import lets_light_through, mitsuba_scene
from points import Points
from scene import Material, Mesh

BATCHES = 64
# Chance that a right estimate fails one test by accident.
SIGNIFICANCE = 1e-5
Z = NormalDist().inv_cdf(1 - SIGNIFICANCE / 2)

BLACK = Material(base_color=(0, 0, 0))
UP = (0.0, 1.0, 0.0)


def rectangle(corner, edge_u, edge_v, material, texcoord=None):
    """Faces along cross(edge_u, edge_v)."""
    corner, edge_u, edge_v = (np.array(v, np.float32) for v in (corner, edge_u, edge_v))
    position = np.array([corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v])
    return Mesh(material, position, np.array([[0, 1, 2], [0, 2, 3]], np.uint32), texcoord=(texcoord, None))


def box(center, half, material, inward):
    """Six faces, their fronts inside or outside."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float32)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))], np.uint32)
    if inward:
        triangles = triangles[:, ::-1]
    return Mesh(material, np.float32(half) * corners + np.array(center, np.float32), triangles.copy())


def point_at(position, normal=UP, geometric_normal=UP):
    return Points(*(np.array([v], float) for v in (position, normal, geometric_normal)))


def unit(v):
    return np.array(v, float) / np.linalg.norm(v)


def png(rows):
    """Encoded bytes of an image: (height, width, channels) numbers from 0 to 255."""
    stream = mi.MemoryStream()
    mi.Bitmap(np.array(rows, np.uint8)).write(stream, mi.Bitmap.FileFormat.PNG)
    stream.seek(0)
    return bytes(stream.read(stream.size()))


def estimate(scene, points, samples_per_batch=64, seed=1):
    method = Method(lets_light_through(scene))
    return estimate_irradiance(mitsuba_scene(scene), points, BATCHES, samples_per_batch, seed, method)
