"""Does the comparison pass what is right and notice what is not?"""

import unittest

import numpy as np

from agreement import compare
from input_error import InputError
from irradiance import Estimate
from mitsuba_scene import mitsuba_scene
from points import Points
from reference_file import Reference, check_points_lie_on
from scene import Material, Scene
from test_scenes import BATCHES, UP, Z, box, estimate, rectangle


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
