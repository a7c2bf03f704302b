"""Mitsuba's irradiances against closed forms."""

import unittest
from dataclasses import replace

import numpy as np

from scene import DirectionalLight, Material, PointLight, Scene, SpotLight, TextureUse
from test_scenes import BLACK, UP, Z, box, estimate, png, point_at, rectangle, unit


def polygon_irradiance(corners, point, normal):
    """Of radiance 1, wholly above the horizon (Lambert 1760; Baum et al. 1989, eq. 4)."""
    to = [unit(np.array(corner) - point) for corner in corners]
    total = np.zeros(3)
    for a, b in zip(to, to[1:] + to[:1]):
        edge = np.cross(a, b)
        total += np.arccos(np.clip(a @ b, -1, 1)) * edge / np.linalg.norm(edge)
    return abs(total @ normal) / 2


def fresnel_reflectance(cosine, index):
    """Of unpolarised light from outside a medium of this index."""
    inside = np.sqrt(1 - (1 - cosine**2) / index**2)
    parallel = (index * cosine - inside) / (index * cosine + inside)
    perpendicular = (cosine - index * inside) / (cosine + index * inside)
    return (parallel**2 + perpendicular**2) / 2


class WithExpectations(unittest.TestCase):
    def expect(self, expected, scene, point, **options):
        got = estimate(scene, point, **options)
        error = np.abs(got.irradiance[0] - expected)
        bound = Z * np.sqrt(got.variance[0]) + 2e-5 * np.array(expected)  # Mitsuba computes in floats
        self.assertTrue((error <= bound).all(), f"{got.irradiance[0]} instead of {expected}, bound {bound}")
        return got


class ClosedForms(WithExpectations):
    def test_furnace(self):
        walls = Material(base_color=(0.2, 0.5, 0.8), emitted_radiance=(1, 2, 3))
        expected = np.pi * np.array([1 / 0.8, 2 / 0.5, 3 / 0.2])
        self.expect(expected, Scene([box((0, 0, 0), 1, walls, inward=True)], [], []), point_at((0.3, -1, 0.2)))

    def test_furnace_stays_uniform_with_glass_and_mirrors_in_it(self):
        walls = Material(base_color=(0.5, 0.5, 0.5), emitted_radiance=(1, 1, 1))
        glass = box((0, -0.4, 0), 0.4, Material(kind="glass", index_of_refraction=1.5), inward=False)
        mirror = box((0.6, 0.5, 0), 0.2, Material(kind="mirror"), inward=False)
        scene = Scene([box((0, 0, 0), 1, walls, inward=True), glass, mirror], [], [])
        self.expect(np.full(3, 2 * np.pi), scene, point_at((0.5, -1, 0.2)))

    def test_emission_on_the_front_only(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1))
        scene = Scene([rectangle((-1, 1, -1), (0, 0, 2), (2, 0, 0), lamp)], [], [])  # faces up
        self.expect(np.zeros(3), scene, point_at((0, 0, 0)))

    def test_rectangle_seen_by_a_tilted_shading_normal(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 2, 3))
        scene = Scene([rectangle((-0.1, 1, 0.5), (0.5, 0, 0), (0, 0, 0.4), lamp)], [], [])  # faces down
        normal = unit((0.3, 1, 0.6))
        corners = [(-0.1, 1, 0.5), (0.4, 1, 0.5), (0.4, 1, 0.9), (-0.1, 1, 0.9)]
        expected = polygon_irradiance(corners, np.zeros(3), normal) * np.array([1, 2, 3])
        self.expect(expected, scene, point_at((0, 0, 0), normal))

    def test_close_below_a_wide_panel(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1))
        scene = Scene([rectangle((-5, 0.01, -5), (10, 0, 0), (0, 0, 10), lamp)], [], [])
        corners = [(-5, 0.01, -5), (5, 0.01, -5), (5, 0.01, 5), (-5, 0.01, 5)]
        got = self.expect(polygon_irradiance(corners, np.zeros(3), np.array(UP)) * np.ones(3), scene, point_at((0, 0, 0)))
        self.assertLess(np.sqrt(got.variance[0, 0]), 0.01 * got.irradiance[0, 0])

    def test_hidden_lamp_beyond_the_shading_horizon(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1))
        screen = rectangle((0.5, -1, -2), (0, 0, 4), (0, 4, 0), BLACK)
        scene = Scene([rectangle((1, 0.1, -0.5), (0, 0, 1), (0, 0.5, 0), lamp), screen], [], [])  # faces the point
        self.expect(np.zeros(3), scene, point_at((0, 0, 0), unit((-1, 0.2, 0))))

    def test_light_below_the_geometric_horizon_does_not_count(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1))
        scene = Scene([rectangle((1, -1, -0.5), (0, 0, 1), (0, 0.9, 0), lamp)], [], [])  # faces -x
        self.expect(np.zeros(3), scene, point_at((0, 0, 0), unit((1, 0.2, 0))))

    def test_lamp_in_a_mirror(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1))
        mirror = Material(kind="mirror", base_color=(0.9, 0.5, 0.1))
        scene = Scene(
            [
                rectangle((0.5, 1, 0.5), (0, 0, 0.5), (0.5, 0, 0), lamp),  # faces up, away from the point
                rectangle((-9, 2, -9), (18, 0, 0), (0, 0, 18), mirror),
            ],
            [],
            [],
        )
        image = [(0.5, 3, 0.5), (1, 3, 0.5), (1, 3, 1), (0.5, 3, 1)]
        # The lamp's own back hides none of its image from here.
        point = np.array([-1.0, 0, -1])
        expected = polygon_irradiance(image, point, np.array(UP)) * np.array(mirror.base_color)
        self.expect(expected, scene, point_at(point), samples_per_batch=1024)

    def test_wide_lamp_through_a_tinted_pane(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1))
        tint, index = np.array([1, 0.9, 0.7]), 1.5
        glass = Material(kind="glass", base_color=tuple(tint), index_of_refraction=index)
        x, z = np.eye(3)[0] * 400, np.eye(3)[2] * 400
        scene = Scene(
            [
                rectangle((-200, 0.5, -200), x, z, glass),  # faces down
                rectangle((-200, 0.6, -200), z, x, glass),  # faces up
                rectangle((-200, 1, -200), x, z, lamp),
            ],
            [],
            [],
        )
        # All orders of reflection between the faces, each event tinted; mean over cosine-distributed directions.
        cosine = np.sqrt((np.arange(20000) + 0.5) / 20000)
        reflected = fresnel_reflectance(cosine, index)[:, None]
        passed = tint**2 * (1 - reflected) ** 2 / (1 - tint**2 * reflected**2)
        self.expect(np.pi * passed.mean(axis=0), scene, point_at((0, 0, 0)), samples_per_batch=512)

    def test_point_light(self):
        light = PointLight((0.5, 2, 0), (10, 20, 30))
        expected = np.array(light.intensity) * 2 / 4.25**1.5
        floor = rectangle((-1, 0, -1), (0, 0, 2), (2, 0, 0), BLACK)
        self.expect(expected, Scene([floor], [light], []), point_at((0, 0, 0)))

    def test_spot_falls_off_as_gltf_says(self):
        # Where the texture of the falloff is interpolated, it is off by at most 1e-5 of the axial intensity.
        light = SpotLight((0, 2, 0), unit((0.1, -1, 0.2)), (10, 20, 30), 0.7853982, 1.134464)
        floor = rectangle((-9, 0, -9), (0, 0, 18), (18, 0, 0), BLACK)
        for x in (0.0, 1.3, 2.0, 2.2, 2.5, 3.0, 3.5, 4.0, 6.0):
            down = np.array([x, -2, 0.3])
            distance_sq = down @ down
            ramp = (unit(down) @ light.axis - np.cos(light.outer_angle)) / (np.cos(light.inner_angle) - np.cos(light.outer_angle))
            full = np.array(light.intensity) * 2 / distance_sq**1.5
            got = estimate(Scene([floor], [], [light]), point_at((x, 0, 0.3)), samples_per_batch=1)
            np.testing.assert_allclose(got.irradiance[0] / full, np.clip(ramp, 0, 1) ** 2 * np.ones(3), atol=1e-5, rtol=1e-5)


def roof(**material):
    """Faces up, black, wide enough to hide everything above a point below its middle."""
    return rectangle((-5000, 1, -5000), (0, 0, 10000), (10000, 0, 0), Material(base_color=(0, 0, 0), **material))


class SeeThrough(WithExpectations):
    """Light that passes holes and thin sheets as it comes, from each kind of light."""

    sun = DirectionalLight(tuple(unit((0.3, -1, 0))), (3, 2, 1))
    lamp = rectangle((-0.5, 2, -0.5), (1, 0, 0), (0, 0, 1), Material(base_color=(0, 0, 0), emitted_radiance=(3, 2, 1)))

    def scenes(self, between):
        """(scene, irradiance at the origin if nothing were between, cosine of what arrives)"""
        corners = [(x, 2, z) for x, z in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
        by_lamp = polygon_irradiance(corners, np.zeros(3), np.array(UP))
        point = PointLight((0.5, 2, 0), (3, 2, 1))
        yield Scene([between], directional_lights=[self.sun]), -self.sun.direction[1], -self.sun.direction[1]
        yield Scene([between], [point]), 2 / 4.25**1.5, 2 / 4.25**0.5
        yield Scene([between, self.lamp]), by_lamp, None
        yield Scene([between], sky_radiance=(3, 2, 1)), np.pi, None

    def test_holes_and_coverage(self):
        for material, passed in (
            ({"alpha_mode": "BLEND", "alpha": 0.25}, 0.75),
            ({"alpha_mode": "MASK", "alpha": 0.25}, 1),
            ({"alpha_mode": "MASK", "alpha": 0.75}, 0),
            ({"alpha": 0.25}, 0),
        ):
            for scene, open_irradiance, _ in self.scenes(roof(**material)):
                self.expect(passed * open_irradiance * np.array([3, 2, 1]), scene, point_at((0, 0, 0)))

    def test_thin_sheets(self):
        tint = np.array([1, 0.9, 0.7])
        sheet = rectangle((-5000, 1, -5000), (0, 0, 10000), (10000, 0, 0), Material(kind="sheet", base_color=tuple(tint), index_of_refraction=1.5))
        for scene, open_irradiance, cosine in self.scenes(sheet):
            if cosine is None:
                continue
            reflected = fresnel_reflectance(cosine, 1.5)
            passed = (1 - reflected) / (1 + reflected)  # all orders of reflection between the faces
            self.expect(passed * open_irradiance * tint * np.array([3, 2, 1]), scene, point_at((0, 0, 0)))

    def test_furnace_stays_uniform_behind_what_is_half_there(self):
        walls = Material(base_color=(0.5, 0.5, 0.5), emitted_radiance=(1, 1, 1))
        for between in (Material(kind="sheet"), Material(alpha_mode="BLEND", alpha=0.5)):
            sheet = rectangle((-0.9, -0.9, -0.9), (0, 0, 1.8), (1.8, 0, 0), between)
            scene = Scene([box((0, 0, 0), 1, walls, inward=True), sheet])
            self.expect(np.full(3, 2 * np.pi), scene, point_at((0.3, -1, 0.2)))

    def test_a_lamp_that_is_half_there(self):
        half = Material(base_color=(0, 0, 0), emitted_radiance=(1, 1, 1), alpha_mode="BLEND", alpha=0.5)
        scene = Scene([rectangle((-5000, 1, -5000), (10000, 0, 0), (0, 0, 10000), half)], sky_radiance=(3, 3, 3))
        self.expect(np.full(3, np.pi * (0.5 + 1.5)), scene, point_at((0, 0, 0)), samples_per_batch=512)


class Emitters(WithExpectations):
    corners = [(-0.1, 1, 0.5), (0.4, 1, 0.5), (0.4, 1, 0.9), (-0.1, 1, 0.9)]

    def test_both_faces_of_a_double_sided_lamp(self):
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 2, 3), double_sided=True)
        expected = polygon_irradiance(self.corners, np.zeros(3), np.array(UP)) * np.array([1, 2, 3])
        for u, v in (((0.5, 0, 0), (0, 0, 0.4)), ((0, 0, 0.4), (0.5, 0, 0))):
            self.expect(expected, Scene([rectangle((-0.1, 1, 0.5), u, v, lamp)]), point_at((0, 0, 0)))

    def test_both_faces_light_a_closed_room(self):
        walls = Material(base_color=(0.5, 0.5, 0.5), emitted_radiance=(1, 1, 1), double_sided=True)
        scene = Scene([box((0, 0, 0), 1, walls, inward=False)])
        self.expect(np.full(3, 2 * np.pi), scene, point_at((0.3, -1, 0.2)))

    def test_a_lamp_that_shows_its_texture_twice(self):
        """Its coordinates run from 0 to 2 along x: halves of each copy shine."""
        use = TextureUse(png([[[255, 255, 255], [0, 0, 0]] * 32] * 2), 0)
        lamp = Material(base_color=(0, 0, 0), emitted_radiance=(1, 2, 3), emissive_texture=use)
        texcoord = np.array([[0, 0], [2, 0], [2, 1], [0, 1]], np.float32)
        scene = Scene([rectangle((-0.1, 1, 0.5), (0.5, 0, 0), (0, 0, 0.4), lamp, texcoord)])
        expected = polygon_irradiance(self.corners, np.zeros(3), np.array(UP)) * np.array([1, 2, 3]) / 2
        got = estimate(scene, point_at((0, 0, 0)))
        # 128 stripes: their mean is a half but for what the two ends see differently.
        bound = Z * np.sqrt(got.variance[0]) + expected / 64
        self.assertTrue((np.abs(got.irradiance[0] - expected) <= bound).all())

    def test_sky_and_sun(self):
        floor = rectangle((-9, 0, -9), (0, 0, 18), (18, 0, 0), BLACK)
        sun = DirectionalLight(tuple(unit((0, -1, 1))), (2, 4, 6))
        expected = np.pi * np.array([0.5, 1, 2]) + np.sqrt(0.5) * np.array([2, 4, 6])
        self.expect(expected, Scene([floor], directional_lights=[sun], sky_radiance=(0.5, 1, 2)), point_at((0, 0, 0)))

    def test_a_room_of_coloured_vertices(self):
        walls = box((0, 0, 0), 1, Material(base_color=(0.8, 0.8, 0.8), emitted_radiance=(1, 1, 1)), inward=True)
        colored = replace(walls, color=np.tile(np.array([0.5, 0.25, 1, 1], np.float32), (8, 1)))
        expected = np.pi / (1 - 0.8 * np.array([0.5, 0.25, 1]))
        self.expect(expected, Scene([colored]), point_at((0.3, -1, 0.2)))
