"""Can the cross-check be trusted? The conversion and Mitsuba's answers against closed forms, and a planted error.

build/crosscheck-venv/bin/python bench/crosscheck/self_test.py
"""

import json
import struct
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from statistics import NormalDist

import numpy as np

from variant import use_fastest_variant

use_fastest_variant()

import mitsuba as mi  # noqa: E402

from agreement import compare  # noqa: E402
from glb_scene import Material, Mesh, PointLight, Scene, SpotLight, TextureUse, read_scene  # noqa: E402
from input_error import InputError  # noqa: E402
from irradiance import Estimate, estimate_irradiance  # noqa: E402
from mitsuba_scene import linear_of_srgb, mitsuba_scene  # noqa: E402
from points import Points  # noqa: E402
from reference_file import Reference, check_points_lie_on  # noqa: E402

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


def estimate(scene, points, samples_per_batch=64, seed=1):
    return estimate_irradiance(mitsuba_scene(scene), points, BATCHES, samples_per_batch, seed)


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


class ClosedForms(unittest.TestCase):
    def expect(self, expected, scene, point, **options):
        got = estimate(scene, point, **options)
        error = np.abs(got.irradiance[0] - expected)
        bound = Z * np.sqrt(got.variance[0]) + 2e-5 * np.array(expected)  # Mitsuba computes in floats
        self.assertTrue((error <= bound).all(), f"{got.irradiance[0]} instead of {expected}, bound {bound}")
        return got

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


def write_glb(document, binary):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    file = Path(tempfile.mkdtemp()) / "scene.glb"
    file.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return file


def small_document():
    """One triangle, mirrored, turned and moved; a spot; a lamp's material."""
    quarter = float(np.sqrt(0.5))
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"translation": [1, 2, 3], "children": [1, 2]},
            {"mesh": 0, "scale": [-2, 1, 1], "rotation": [0, quarter, 0, quarter]},
            {"rotation": [-quarter, 0, 0, quarter], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [
            {
                "emissiveFactor": [0.5, 1, 0],
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}},
            }
        ],
        "extensions": {
            "KHR_lights_punctual": {"lights": [{"type": "spot", "color": [1, 0, 0.5], "intensity": 8, "spot": {"outerConeAngle": 0.5}}]}
        },
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36}],
    }


class Reader(unittest.TestCase):
    binary = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32).tobytes()

    def test_transforms_materials_and_lights(self):
        scene = read_scene(write_glb(small_document(), self.binary))
        mesh, spot = scene.meshes[0], scene.spot_lights[0]
        # Scaled to (-2, 0, 0), turned about y to (0, 0, 2), moved.
        np.testing.assert_allclose(mesh.position, [[1, 2, 3], [1, 2, 5], [1, 3, 3]], atol=1e-6)
        corners = mesh.position[mesh.triangles[0]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        np.testing.assert_allclose(unit(normal), [1, 0, 0], atol=1e-6)  # +z, turned about y
        self.assertEqual((mesh.material.kind, mesh.material.emitted_radiance), ("diffuse", (2, 4, 0)))
        np.testing.assert_allclose(spot.position, [1, 2, 3])
        np.testing.assert_allclose(spot.axis, [0, -1, 0], atol=1e-6)
        self.assertEqual((spot.intensity, spot.inner_angle, spot.outer_angle), ((8, 0, 4), 0, 0.5))

    def test_refuses_what_it_does_not_convert(self):
        document = small_document()
        document["materials"][0]["doubleSided"] = True
        with self.assertRaises(InputError):
            read_scene(write_glb(document, self.binary))
        with self.assertRaises(InputError):
            read_scene("/dev/null")


class Agreement(unittest.TestCase):
    def setUp(self):
        walls = Material(base_color=(0.5, 0.5, 0.5))
        lamp = Material(emitted_radiance=(4, 4, 4), base_color=(0.5, 0.5, 0.5))
        self.scene = Scene(
            [box((0, 0, 0), 1, walls, inward=True), rectangle((-0.3, 0.9, -0.3), (0.6, 0, 0), (0, 0, 0.6), lamp)], [], []
        )
        position = np.random.default_rng(1).uniform(-0.9, 0.9, (400, 3))
        position[:, 1] = -1
        self.region_of = np.arange(400) // 20
        self.points = Points(position, np.tile(UP, (400, 1)), np.tile(UP, (400, 1)))
        self.first, self.second = (estimate(self.scene, self.points, 4, seed) for seed in (1, 2))

    def test_two_runs_of_the_same_renderer_agree(self):
        agreement = compare(self.first, self.second, self.region_of)
        self.assertEqual(agreement.verdict, "agree")
        # Mean of 1200 squares, a third of them independent, each of variance 2 (a little more: t-distributed).
        self.assertLess(abs(agreement.rms_z**2 - 1), Z * np.sqrt(2 / 400) + 2 / BATCHES)

    def test_a_hundredth_too_much_is_noticed(self):
        brighter = Estimate(1.01 * self.first.irradiance, 1.01**2 * self.first.variance)
        agreement = compare(brighter, self.second, self.region_of)
        self.assertEqual(agreement.verdict, "DIFFER")
        self.assertGreater(agreement.z, 5)

    def test_an_error_that_cancels_in_the_mean_is_noticed(self):
        sign = np.where(np.arange(400) < 200, 1.03, 1.0)[:, None]
        sign[200:] = 1 - 0.03 * self.first.irradiance[:200].mean() / self.first.irradiance[200:].mean()
        agreement = compare(Estimate(sign * self.first.irradiance, sign**2 * self.first.variance), self.second, self.region_of)
        self.assertLess(max(map(abs, agreement.channel_z)), 3)
        self.assertEqual(agreement.verdict, "DIFFER")

    def test_points_of_another_scene_are_refused(self):
        traced = mitsuba_scene(self.scene)
        check_points_lie_on(traced, Reference(self.points, self.first, self.region_of, {}), "right.exr")
        lifted = Points(self.points.position + 0.1, self.points.shading_normal, self.points.geometric_normal)
        with self.assertRaises(InputError):
            check_points_lie_on(traced, Reference(lifted, self.first, self.region_of, {}), "wrong.exr")


if __name__ == "__main__":
    unittest.main()
