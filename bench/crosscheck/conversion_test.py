"""Does Mitsuba get the surfaces that the file describes?"""

import unittest
from dataclasses import replace

import mitsuba as mi
import numpy as np

from mitsuba_scene import linear_of_srgb, mitsuba_scene
from scene import Material, Scene, TextureUse
from test_scenes import UP, rectangle, unit


class Normals(unittest.TestCase):
    def shading_normal_of(self, kind):
        flat = rectangle((-1, 0, -1), (0, 0, 2), (2, 0, 0), Material(kind=kind))
        smooth = replace(flat, normal=np.tile(np.array(self.given, np.float32), (4, 1)))
        scene = mitsuba_scene(Scene([smooth], [], []))
        surface = scene.ray_intersect(mi.Ray3f(mi.Point3f(0.3, 1, 0.2), mi.Vector3f(0, -1, 0)))
        return np.array(surface.sh_frame.n).ravel()

    given = unit((0.3, 1, 0))

    def test_diffuse_surfaces_reflect_round_the_geometric_normal(self):
        np.testing.assert_allclose(self.shading_normal_of("diffuse"), UP, atol=1e-6)

    def test_mirrors_and_glass_follow_the_vertex_normals(self):
        for kind in ("mirror", "glass"):
            np.testing.assert_allclose(self.shading_normal_of(kind), self.given, atol=1e-6)


class Textures(unittest.TestCase):
    def test_texels_lie_where_gltf_says(self):
        rows = np.array([[[250, 10, 20], [30, 200, 40]], [[50, 60, 128], [90, 90, 90]]], np.uint8)
        stream = mi.MemoryStream()
        mi.Bitmap(rows).write(stream, mi.Bitmap.FileFormat.PNG)
        stream.seek(0)
        use = TextureUse(bytes(stream.read(stream.size())), 0, "repeat")
        texcoord = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)
        textured = rectangle((0, 0, 0), (1, 0, 0), (0, 1, 0), Material(base_color=(1, 0.5, 1), base_color_texture=use), texcoord)
        scene = mitsuba_scene(Scene([textured], [], []))
        texels = linear_of_srgb(rows / 255.0) * np.array([1, 0.5, 1])
        between_ends = texels[0].mean(axis=0)  # repeat: u = 0 lies between the last texel and the first
        for u, v, expected in ((0.25, 0.25, texels[0, 0]), (0.75, 0.25, texels[0, 1]), (0.25, 0.75, texels[1, 0]), (1e-4, 0.25, between_ends)):
            surface = scene.ray_intersect(mi.Ray3f(mi.Point3f(u, v, 1), mi.Vector3f(0, 0, -1)))
            albedo = np.array(surface.bsdf().eval_diffuse_reflectance(surface)).ravel()
            np.testing.assert_allclose(albedo, expected, atol=1e-3)
