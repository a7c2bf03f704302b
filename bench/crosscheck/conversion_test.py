"""Does Mitsuba get the surfaces that the file describes?"""

import unittest
from dataclasses import replace

import mitsuba as mi
import numpy as np

from images import linear_of_srgb
from input_error import InputError
from mitsuba_scene import lets_light_through, mitsuba_scene
from roulette import roulette_depth
from scene import Material, Scene, TextureUse
from test_scenes import UP, png, rectangle, unit


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
    rows = np.array([[[250, 10, 20], [30, 200, 40]], [[50, 60, 128], [90, 90, 90]]], np.uint8)
    factor = (1, 0.5, 1)
    texels = linear_of_srgb(rows / 255.0) * np.array(factor)
    unit_square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)

    def albedo(self, mesh, x, y):
        scene = mitsuba_scene(Scene([mesh]))  # must outlive what was found in it
        surface = scene.ray_intersect(mi.Ray3f(mi.Point3f(x, y, 1), mi.Vector3f(0, 0, -1)))
        return np.array(surface.bsdf().eval_diffuse_reflectance(surface)).ravel()

    def textured(self, texcoord=unit_square, **use):
        material = Material(base_color=self.factor, base_color_texture=TextureUse(png(self.rows), **use))
        return rectangle((0, 0, 0), (1, 0, 0), (0, 1, 0), material, texcoord)

    def test_texels_lie_where_gltf_says(self):
        between_ends = self.texels[0].mean(axis=0)  # repeat: u = 0 lies between the last texel and the first
        for u, v, expected in (
            (0.25, 0.25, self.texels[0, 0]),
            (0.75, 0.25, self.texels[0, 1]),
            (0.25, 0.75, self.texels[1, 0]),
            (1e-4, 0.25, between_ends),
        ):
            np.testing.assert_allclose(self.albedo(self.textured(), u, v), expected, atol=1e-3)

    def test_moved_coordinates(self):
        # Looked up at (v + 0.5, u), wrapped: the images of (0.25, 0.25) and (0.25, 0.75) are (0.75, 0.25) and (0.25, 0.25).
        mesh = self.textured(to_uv=((0, 1, 0.5), (1, 0, 0), (0, 0, 1)))
        np.testing.assert_allclose(self.albedo(mesh, 0.25, 0.25), self.texels[0, 1], atol=1e-3)
        np.testing.assert_allclose(self.albedo(mesh, 0.25, 0.75), self.texels[0, 0], atol=1e-3)

    def test_each_axis_wraps_in_its_own_way(self):
        wide = 4 * self.unit_square - 1  # from -1 to 3
        mesh = self.textured(wide, wrap=("mirror", "clamp"))
        for u, v, expected in (
            (1.25, 0.25, self.texels[0, 1]),
            (1.75, 0.25, self.texels[0, 0]),
            (2.25, 0.25, self.texels[0, 0]),
            (-0.25, 0.25, self.texels[0, 0]),
            (-0.75, 0.25, self.texels[0, 1]),
            (0.25, 2.5, self.texels[1, 0]),
            (0.25, -0.9, self.texels[0, 0]),
            (1.0, 0.25, self.texels[0, 1]),  # mirrored: on both sides the last texel
        ):
            got = self.albedo(mesh, (u + 1) / 4, (v + 1) / 4)
            np.testing.assert_allclose(got, expected, atol=1e-3, err_msg=f"{u}, {v}")

    def test_colours_of_vertices_multiply(self):
        color = np.array([[1, 1, 1, 1], [0, 1, 0.5, 1], [0, 1, 0.5, 1], [1, 1, 1, 1]], np.float32)
        plain = rectangle((0, 0, 0), (1, 0, 0), (0, 1, 0), Material(base_color=self.factor))
        along = np.array([0.75, 1, 0.875])  # a quarter of the way
        np.testing.assert_allclose(self.albedo(replace(plain, color=color), 0.25, 0.25), along * self.factor, atol=1e-5)
        got = self.albedo(replace(self.textured(), color=color), 0.25, 0.25)
        np.testing.assert_allclose(got, along * self.texels[0, 0], atol=1e-3)

    def test_two_sets_of_coordinates_in_one_material_are_refused(self):
        mesh = self.textured()
        other = replace(mesh.material, emissive_texture=TextureUse(png(self.rows), 1), emitted_radiance=(1, 1, 1))
        with self.assertRaises(InputError):
            mitsuba_scene(Scene([replace(mesh, material=other)]))


class Alpha(unittest.TestCase):
    """What part of a surface Mitsuba takes to be there."""

    def opacity(self, mesh, x, y):
        scene = mitsuba_scene(Scene([mesh]))
        surface = scene.ray_intersect(mi.Ray3f(mi.Point3f(x, y, 1), mi.Vector3f(0, 0, -1)))
        return 1 - np.array(surface.bsdf().eval_null_transmission(surface)).ravel()[0]

    def sheet(self, color=None, **material):
        image = png([[[255, 255, 255, 255], [255, 255, 255, 0]]] * 2)
        use = TextureUse(image, 0, ("clamp", "clamp"))
        mesh = rectangle((0, 0, 0), (1, 0, 0), (0, 1, 0), Material(base_color_texture=use, **material), Textures.unit_square)
        return mesh if color is None else replace(mesh, color=np.tile(np.array(color, np.float32), (4, 1)))

    def test_blend(self):
        # Linear from 1 at u = 0.25 to 0 at u = 0.75.
        for u, expected in ((0.1, 1), (0.4, 0.7), (0.9, 0)):
            self.assertAlmostEqual(self.opacity(self.sheet(alpha_mode="BLEND"), u, 0.5), expected, places=4)
            half = self.sheet(alpha_mode="BLEND", alpha=0.5)
            self.assertAlmostEqual(self.opacity(half, u, 0.5), expected / 2, places=4)
            quarter = self.sheet((1, 1, 1, 0.5), alpha_mode="BLEND", alpha=0.5)
            self.assertAlmostEqual(self.opacity(quarter, u, 0.5), expected / 4, places=4)

    def test_mask_cuts_after_filtering(self):
        for cutoff in (0.25, 0.5, 0.75):
            edge = 0.75 - cutoff / 2
            mesh = self.sheet(alpha_mode="MASK", alpha_cutoff=cutoff)
            self.assertEqual((self.opacity(mesh, edge - 0.01, 0.5), self.opacity(mesh, edge + 0.01, 0.5)), (1, 0))

    def test_opaque_surfaces_have_no_alpha(self):
        self.assertFalse(lets_light_through(Scene([self.sheet(alpha=0.5)])))
        self.assertEqual(self.opacity(self.sheet(alpha=0.5), 0.9, 0.5), 1)
        self.assertTrue(lets_light_through(Scene([self.sheet(alpha_mode="BLEND")])))


class Roulette(unittest.TestCase):
    def depth(self, albedo):
        dark = rectangle((0, 0, 0), (1, 0, 0), (0, 1, 0), Material(base_color=(0, 0, 0)))
        bright = rectangle((0, 0, 0), (3, 0, 0), (0, 1, 0), Material(base_color=(0, albedo, 0)))
        return roulette_depth(Scene([dark, bright]))

    def test_begins_where_a_tenth_is_left(self):
        self.assertEqual(self.depth(0.8 / 0.75), 11)  # mean 0.8: 0.8^10.3 = 0.1
        self.assertEqual(self.depth(0.1), 5)
        self.assertEqual(self.depth(4 / 3), 200)
