"""The report on scenes that others made: figures, bounds, which files count, and whole runs with a program that only pretends to measure."""

import contextlib
import io
import json
import math
import sys
import time
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.elsewhere import report as elsewhere
from report.elsewhere import run as elsewhere_run
from report.elsewhere.bounds import bounds_of, verdict_of
from report.elsewhere.figures import MISSED, PASSED, UNDECIDED, figures
from report.elsewhere.record import full_names
from report.elsewhere.scenes import find_scenes
from report.study.data import EPSILON_SHARE, Scene, StudyError
from study_laws import Folder

WIDTH, HEIGHT = 96, 54
FAKE = Path(__file__).resolve().parent / "fake_shlmbench.py"
METHODS = "shlm,photonmap,shlm/L2/radiance/surface4,photonmap/compact"


def scene_of(reference, pixel=None, variance=0.0):
    reference = np.asarray(reference, float)
    epsilon = EPSILON_SHARE * reference.mean() ** 2
    pixel = np.arange(len(reference), dtype=np.uint32) if pixel is None else pixel
    weight = 1 / (reference**2 + epsilon)
    return Scene("room", reference, np.full_like(reference, variance), np.zeros(len(reference)), pixel, epsilon, weight)


def room():
    """Every pixel sees a surface; light from 0.5 to 2, in three colours."""
    x, y = np.arange(WIDTH * HEIGHT) % WIDTH, np.arange(WIDTH * HEIGHT) // WIDTH
    level = 0.5 + 1.5 * (x / WIDTH) * (y / HEIGHT)
    return scene_of(level[:, None] * np.array([1, 0.8, 0.6]))


def region(column, row):
    """Points of one square of 8 x 8."""
    x, y = np.meshgrid(np.arange(8) + 8 * column, np.arange(8) + 8 * row)
    return (y * WIDTH + x).ravel()


def noisy(scene, seeds, relative, generator):
    """Photons: the variance grows with the light."""
    scale = relative * np.sqrt(scene.reference * scene.reference.mean())
    return scene.reference + scale * generator.normal(size=(seeds, *scene.reference.shape))


class Figures(unittest.TestCase):
    def test_what_was_planted_is_found(self):
        scene = room()
        answers = np.stack([scene.reference] * 2)
        answers[:, region(3, 2)] *= 0.9
        answers[:, region(5, 1)] *= 1.04
        found = figures(scene, answers, WIDTH)
        lost = 0.1 * scene.reference[region(3, 2)].sum() - 0.04 * scene.reference[region(5, 1)].sum()
        self.assertAlmostEqual(found.mean.value, -lost / scene.reference.sum())
        self.assertAlmostEqual(found.worst_region.value, -0.1)
        self.assertEqual(found.regions, 12 * 6)  # the last six rows make no whole square
        squares = ((answers[0] - scene.reference) ** 2 * scene.weight).mean()
        self.assertAlmostEqual(found.rms, math.sqrt(squares))

    def test_squares_that_a_surface_does_not_fill_are_no_regions(self):
        whole = room()
        kept = np.setdiff1d(np.arange(whole.points), [region(3, 2)[17], *region(5, 1)])
        scene = scene_of(whole.reference[kept], kept)
        answers = scene.reference * np.where(np.isin(kept, region(3, 2)), 2, 1)[:, None]
        found = figures(scene, answers[None], WIDTH)
        self.assertEqual((found.regions, found.worst_region.value), (12 * 6 - 2, 0))
        self.assertTrue(math.isnan(found.mean.chance))  # a single seed says nothing of chance

    def test_chance_is_what_seeds_differ_by(self):
        """The mean over many studies of the squared error is what chance says, within a part that 200 of them leave open."""
        scene, generator = room(), np.random.default_rng(3)
        found = [figures(scene, noisy(scene, 2, 0.3, generator), WIDTH).mean for _ in range(200)]
        ratio = np.mean([e.value**2 for e in found]) / np.mean([e.chance**2 for e in found])
        self.assertLess(abs(ratio - 1), 4.4 * math.sqrt(2 / 200))

    def test_the_references_noise_counts(self):
        exact = room()
        scene = scene_of(exact.reference, variance=0.01)
        found = figures(scene, exact.reference[None].repeat(2, axis=0), WIDTH)
        self.assertAlmostEqual(found.mean.chance, math.sqrt(0.01 * exact.reference.size) / exact.reference.sum())
        self.assertEqual(found.rms, 0)


class Bounds(unittest.TestCase):
    def judged(self, change, noise=0.0):
        scene = room()
        answers = noisy(scene, 2, noise, np.random.default_rng(5)) * change(scene)
        right = figures(scene, scene.reference[None].repeat(2, axis=0), WIDTH)
        return bounds_of({"shlm": figures(scene, answers, WIDTH), "photonmap": right})

    def test_right_answers_pass(self):
        bounds = self.judged(lambda scene: 1.0)
        self.assertEqual([b.verdict for b in bounds], [PASSED] * 3)
        self.assertEqual(verdict_of(bounds), PASSED)

    def test_three_percent_too_much_is_flagged(self):
        for change in (1.03, 0.97):
            bounds = self.judged(lambda scene: change, noise=0.05)
            self.assertEqual([b.verdict for b in bounds], [MISSED, MISSED, PASSED])
            self.assertEqual(verdict_of(bounds), MISSED)

    def test_three_percent_in_one_region_are_flagged(self):
        def brighter(scene):
            factor = np.ones((scene.points, 1))
            factor[region(3, 2)] = 1.03
            return factor

        self.assertEqual([b.verdict for b in self.judged(brighter, noise=0.01)], [PASSED, MISSED, PASSED])

    def test_chance_alone_is_not_flagged(self):
        bounds = self.judged(lambda scene: 1.0, noise=0.5)
        self.assertGreater(abs(bounds[1].error.value), 0.02)
        self.assertEqual([b.verdict for b in bounds], [PASSED, UNDECIDED, PASSED])

    def test_a_dark_region_does_not_hide_a_wrong_one(self):
        """By chance the dark one is further off; the other is off by more than chance."""
        scene = room()
        scene.reference[region(0, 0)] *= 1e-6
        answers = noisy(scene, 2, 0.05, np.random.default_rng(5))
        answers[:, region(11, 5)] *= 1.1
        found = figures(scene, answers, WIDTH)
        self.assertGreater(abs(found.worst_region.value), 0.2)
        bound = bounds_of({"shlm": found})[1]
        self.assertEqual(bound.verdict, MISSED)
        self.assertAlmostEqual(bound.error.value, 0.1, delta=0.02)


def write_scene(file, **extras):
    """A glTF file that tells fake_shlmbench.py what to pretend; without `lit` there is a lamp in it."""
    lit = extras.pop("lit", True)
    materials = [{"emissiveFactor": [1, 1, 1]}] if lit else []
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps({"asset": {"version": "2.0"}, "materials": materials, "extras": extras}), encoding="utf-8")


class Finding(Folder):
    def names(self):
        return [scene.name for scene in find_scenes(self.folder)[0]]

    def test_lit_copies_stand_for_their_scenes_and_hostile_files_are_left_alone(self):
        for name in ("hall/hall.gltf", "hall/hall.lit.gltf", "attic/attic.glb", "hostile/broken.gltf", "a/hostile/worse.gltf"):
            write_scene(self.folder / name)
        write_scene(self.folder / "dark.gltf", lit=False)
        scenes, dark = find_scenes(self.folder)
        self.assertEqual([scene.name for scene in scenes], ["attic", "hall.lit"])
        self.assertEqual([file.name for file in dark], ["dark.gltf"])

    def test_scenes_of_the_same_name(self):
        for name in ("a/room.gltf", "b/room.gltf", "b/other.gltf"):
            write_scene(self.folder / name)
        self.assertEqual(self.names(), ["a-room", "other", "b-room"])

    def test_what_the_list_says(self):
        write_scene(self.folder / "a" / "yard.gltf", lit=False)
        (self.folder / "scenes.txt").write_text('a/yard.gltf --sky 1,1,1 --camera "0,0,0,1,1,1,60"  # a note\n', encoding="utf-8")
        self.assertEqual(find_scenes(self.folder)[0][0].options, ("--sky", "1,1,1", "--camera", "0,0,0,1,1,1,60"))
        for line in ("gone.gltf", "a/yard.gltf --out x", "a/yard.gltf --sky", 'a/yard.gltf "'):
            (self.folder / "scenes.txt").write_text(line, encoding="utf-8")
            with self.assertRaises(StudyError) as raised:
                find_scenes(self.folder)
            self.assertNotIn("\n", str(raised.exception))

    def test_folders_of_no_use(self):
        write_scene(self.folder / "dark.gltf", lit=False)
        for folder in (self.folder, self.folder / "gone", self.folder / "dark.gltf"):
            with self.assertRaises(StudyError):
                find_scenes(folder)

    def test_a_file_that_cannot_be_read_is_tried(self):
        write_scene(self.folder / "hall.gltf")
        (self.folder / "broken.glb").write_bytes(b"glTF")
        self.assertEqual(self.names(), ["broken", "hall"])

    def test_credits(self):
        write_scene(self.folder / "a" / "hall.gltf")
        write_scene(self.folder / "b" / "yard.gltf")
        write_scene(self.folder / "c" / "loft.gltf")
        (self.folder / "a" / "NOTE.md").write_text("# hall\n- Source: a/b `c|d`\n- Licence: MIT (text beside)\n", encoding="utf-8")
        (self.folder / "a" / "LICENSE").write_text("Copyright (c) 2020 Ann Example. \\\nPermission\n", encoding="utf-8")
        (self.folder / "b" / "LICENSE.txt").write_text("* title:\tThe Yard\n* author:\tBob\n* license type:\tCC-BY-4.0\n", encoding="utf-8")
        (self.folder / "c" / "LICENSE-ATTRIBUTION.md").write_text('"Loft" by Cy Example.\n', encoding="utf-8")
        write_scene(self.folder / "d" / "mill.gltf")
        (self.folder / "d" / "LICENSE").write_text("as defined by Sections 1 through 9\nby the Work\n", encoding="utf-8")
        hall, yard, loft, mill = (scene.credit for scene in find_scenes(self.folder)[0])
        self.assertEqual(hall, {"source": "a/b c/d", "licence": "MIT (text beside)", "author": "Copyright (c) 2020 Ann Example."})
        self.assertEqual(yard, {"title": "The Yard", "author": "Bob", "licence": "CC-BY-4.0"})
        self.assertEqual(loft, {"author": '"Loft" by Cy Example.'})
        self.assertEqual(mill, {})  # licences speak of much


class Names(unittest.TestCase):
    def test_short_names_stand_for_what_no_longer_one_asks_for(self):
        measured = ["shlm/L2/radiance/surface4", "shlm/L2/radiance/new", "photonmap/flann/k50/disc", "photonmap/compact/k50/disc"]
        found = full_names(METHODS.split(","), measured)
        self.assertEqual(found["shlm"], "shlm/L2/radiance/new")
        self.assertEqual(found["shlm/L2/radiance/surface4"], "shlm/L2/radiance/surface4")
        self.assertEqual(found["photonmap"], "photonmap/flann/k50/disc")
        self.assertEqual(found["photonmap/compact"], "photonmap/compact/k50/disc")

    def test_the_default_may_be_asked_for_twice(self):
        found = full_names(["shlm", "shlm/L2/radiance/surface4"], ["shlm/L2/radiance/surface4"])
        self.assertEqual(set(found.values()), {"shlm/L2/radiance/surface4"})
        self.assertEqual(full_names(["shlm", "photonmap"], ["shlm/L2/radiance/surface4"]), {"shlm": "shlm/L2/radiance/surface4"})


class Runs(Folder):
    def setUp(self):
        super().setUp()
        self.scenes, self.out = self.folder / "scenes", self.folder / "out"

    def run_elsewhere(self, *more):
        """(exit code, stdout, stderr)"""
        out, errors = io.StringIO(), io.StringIO()
        arguments = [str(FAKE), str(self.scenes), str(self.out), "--methods", METHODS, *more]
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            code = elsewhere.main(arguments)
        return code, out.getvalue(), errors.getvalue()

    def report(self):
        return (self.out / "report.md").read_text(encoding="utf-8")

    def document(self):
        return json.loads((self.out / "elsewhere.json").read_text(encoding="utf-8"))

    def calls(self, name):
        """What the program was asked to do with a scene, in order."""
        file = self.scenes / f"{name}.calls"
        return file.read_text(encoding="utf-8").split() if file.exists() else []

    def test_whole_run(self):
        write_scene(self.scenes / "hall.gltf", warning="nothing to speak of")
        write_scene(self.scenes / "yard.gltf", error=0.03)
        write_scene(self.scenes / "crypt.gltf", fails="crypt.gltf: has no door")
        code, out, errors = self.run_elsewhere()
        self.assertEqual(code, 1)
        self.assertEqual([line.split(" | ")[0] for line in out.splitlines()[:3]], ["crypt", "hall", "yard"])
        crypt, hall, yard = self.document()["scenes"]
        self.assertEqual(crypt["failed"], "shlmbench: crypt.gltf: has no door")
        self.assertEqual((hall["verdict"], yard["verdict"]), (PASSED, MISSED))
        self.assertAlmostEqual(yard["methods"][0]["mean"]["value"], 0.03, places=2)
        self.assertEqual(len(hall["methods"]), 3 * 2)  # the default is one of those asked for by their full names
        self.assertEqual(hall["reference"]["samples_per_pixel"], 640)
        self.assertEqual(self.document()["settings"]["methods"], METHODS)
        self.assertEqual(hall["context"]["commit"], "0123456789ab")
        text = self.report()
        for piece in (
            "| crypt | - |",
            "not measured: shlmbench: crypt.gltf: has no door",
            "- light map, mean: +2.98",
            "- warning: nothing to speak of",
            "![hall](images/hall.png)",
            "shlm/L2/radiance/surface4, 1\u00a0M hits",
            "commit 0123456789ab",
        ):
            self.assertIn(piece, text)
        self.assertFalse((self.out / "work").exists())
        size = sum(file.stat().st_size for file in self.out.rglob("*") if file.is_file())
        self.assertLess(size, 2 * 330_000)  # nine scenes: 3 MB

    def test_a_run_that_was_stopped_goes_on(self):
        for name in ("hall", "yard"):
            write_scene(self.scenes / f"{name}.gltf")
        real = elsewhere_run.run

        def stopped(command, seconds=None):
            if "study" in map(str, command) and any("yard" in str(c) for c in command):
                raise KeyboardInterrupt
            return real(command, seconds)

        with mock.patch.object(elsewhere_run, "run", stopped), self.assertRaises(KeyboardInterrupt):
            self.run_elsewhere()
        self.assertEqual([scene["name"] for scene in self.document()["scenes"]], ["hall"])
        self.assertIn("| hall |", self.report())
        first = self.calls("hall")
        self.assertEqual(first, ["info", "reference", "study", "fit"])
        self.assertEqual(self.calls("yard"), ["info", "reference"])
        self.assertTrue((self.out / "work" / "yard" / "references" / "yard.exr").exists())  # it goes on from there

        self.assertEqual(self.run_elsewhere()[0], 0)
        self.assertEqual(self.calls("hall"), first)
        self.assertEqual(self.calls("yard")[2:], ["info", "reference", "study", "fit"])
        self.assertEqual([scene["name"] for scene in self.document()["scenes"]], ["hall", "yard"])

    def test_another_scene_of_that_name_is_measured_anew(self):
        write_scene(self.scenes / "hall.gltf")
        self.assertEqual(self.run_elsewhere()[0], 0)
        write_scene(self.scenes / "hall.gltf", error=0.03)
        self.assertEqual(self.run_elsewhere()[0], 1)
        self.assertEqual(self.calls("hall").count("study"), 2)

    def test_a_scene_that_failed_is_tried_again(self):
        write_scene(self.scenes / "hall.gltf", fails="not today")
        self.assertEqual(self.run_elsewhere()[0], 1)
        self.assertEqual(self.run_elsewhere()[0], 1)
        self.assertEqual(self.calls("hall"), ["info", "info"])

    def test_what_takes_too_long_is_stopped_and_its_state_said(self):
        write_scene(self.scenes / "hall.gltf", slow=["reference", "fit"])

        def out_of_time(process, seconds):
            """As soon as the program can be stopped, whatever the machine does meanwhile."""
            while seconds and not (self.scenes / f"{process.pid}.ready").exists() and process.poll() is None:
                time.sleep(0.01)
            return process.communicate(timeout=0.01 if seconds else None)

        with mock.patch.object(elsewhere_run, "output_within", out_of_time):
            code, _, _ = self.run_elsewhere("--fit-seconds", "1")
        self.assertEqual(code, 0)
        (hall,) = self.document()["scenes"]
        self.assertEqual(hall["reference"]["samples_per_pixel"], 64)
        self.assertEqual(hall["fit"], {"reason": "no answer within 3 s"})

    def test_options_of_the_list_reach_every_command(self):
        write_scene(self.scenes / "yard.gltf", lit=False, needs="--sky")
        (self.scenes / "scenes.txt").write_text("yard.gltf --sky 1,1,1\n", encoding="utf-8")
        self.assertEqual(self.run_elsewhere()[0], 0)
        self.assertIn("With --sky 1,1,1.", self.report())

    def test_a_bad_folder_is_one_line_and_code_2(self):
        code, out, errors = self.run_elsewhere()
        self.assertEqual((code, out), (2, ""))
        self.assertEqual(len(errors.splitlines()), 1)
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
