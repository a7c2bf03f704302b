"""The exported page in a headless Chromium: what its fragment programs draw, beside what the program answers. viewer_test.py SHLMBENCH SCENES_FOLDER

Skipped where no browser is installed."""

import base64
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report import realtime
from report.browser import SOFTWARE_GRAPHICS, Browser, find_browser

MAPS = ("shlm/L2/radiance/bilinear", "shlm/L4/radiance/bilinear", "shlm/L0/normalised/bilinear", "shlm/AD/radiance/bilinear",
        "shlm/F0/flux/bilinear", "shlm/F1/radiance/bilinear", "shlm/F2/radiance/bilinear",
        "shlm/YF1/radiance/bilinear", "shlm/YF2/radiance/bilinear")
EXACT = 1e-4  # relative RMS, largest there may be
HARDWARE = 0.5  # of what the graphics card mixes itself: covered area does not count, and chart borders show
ADAPTIVE = "shlm/a8"
SCENES = {"cornell": ("cornell", "uv,4096"), "bumpy": ("bumpy", "uv,4096"), "bumpy by face": ("bumpy", "face,4096"), "caustic by face": ("caustic", "face,4096")}


def glb_text(file):
    return base64.b64encode(file.read_bytes()).decode()


def export(name, out):
    scene, texels = SCENES[name]
    words = [PROGRAM, "export", str(SCENE_FOLDER / f"{scene}.glb"), "--texels", texels, "--hits", "300000", "--method", ",".join([*MAPS, "photonmap/compact"]),
             "--out", str(out)]
    subprocess.run(words, check=True, capture_output=True, timeout=600)


@unittest.skipUnless(find_browser(), "no Chromium is installed: the page is not opened (.ci/prepare installs chromium-headless-shell)")
class Viewer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.root = Path(temporary.name)
        for name in SCENES:
            export(name, cls.root / name)
        cls.browser = Browser(find_browser(), SOFTWARE_GRAPHICS)
        cls.addClassCleanup(cls.browser.close)

    def open(self, name, state="", width=800, height=400):
        self.browser.open((self.root / name / "viewer.html").as_uri() + (f"#{state}" if state else ""), width, height)
        self.browser.evaluate("window.shlmViewer.then(() => true)")

    @property
    def complaints(self):
        """Without those of speed: reading pixels back is slow."""
        return [said for said in self.browser.complaints if "Performance" not in said]

    def results_of(self, name, state=""):
        self.open(name, state)
        return self.browser.evaluate("window.shlmTest()")

    def test_every_basis_gives_the_programs_answers(self):
        for name in SCENES:
            with self.subTest(name):
                result = self.results_of(name)
                self.assertEqual(self.complaints, [])
                self.assertEqual([r for r in self.browser.requests if not r.startswith(("file:", "data:", "blob:"))], [])
                self.assertEqual({row["method"] for row in result["rows"]}, {f"{m}/half" for m in MAPS})
                for row in result["rows"]:
                    with self.subTest(f"{row['method']} {row['filter']}"):
                        self.assertGreater(row["points"], 1000)
                        self.assertLess(row["rms"], EXACT if row["filter"] == "exact" else HARDWARE)
                self.assertTrue(result["passed"])

    def test_an_adaptive_map_gives_the_answers_of_its_texels(self):
        folder, reference = self.root / "adaptive", self.root / "reference.exr"
        scene = SCENE_FOLDER / "bumpy.glb"
        for words in (["reference", scene, "--out", reference, "--width", 64, "--height", 36, "--spp", 16],
                      ["export", scene, "--texels", "face,16384", "--hits", "1000000", "--method", ADAPTIVE, "--reference", reference, "--out", folder]):
            subprocess.run([PROGRAM, *map(str, words)], check=True, capture_output=True, timeout=600)
        result = self.results_of("adaptive")
        self.assertEqual(self.complaints, [])
        self.assertTrue(result["passed"], result["rows"])
        self.assertEqual([row["basis"] for row in result["rows"]], ["F2", "F2"])
        self.assertLess(result["rows"][0]["error"], 0.3)
        # With a reference, each disc has its mark.
        self.browser.evaluate("window.shlmViewer.then(viewer => viewer.probe(viewer.canvas.clientWidth / 2, viewer.canvas.clientHeight * 0.6))")
        said = self.browser.evaluate("document.getElementById('probe').textContent")
        self.assertIn("Reference at the nearest", said)
        self.assertIn("round mark", said)

    def test_planted_mistakes_are_found(self):
        for name, faults in {"bumpy": ("order", "tangent", "texcoord", "atlas", "constant"), "bumpy by face": ("atlas", "tangent")}.items():
            for fault in faults:
                with self.subTest(f"{name}: {fault}"):
                    result = self.results_of(name, f"fault={fault}")
                    self.assertFalse(result["passed"])
                    self.assertGreater(max(row["rms"] for row in result["rows"] if row["filter"] == "exact"), 5 * EXACT)

    def pixels(self, state):
        """How many different colours the canvas has, and its mean colour."""
        self.open("bumpy", state)
        return self.browser.evaluate("""window.shlmViewer.then(viewer => { viewer.drawNow(); const { gl } = viewer.renderer, w = viewer.canvas.width, h = viewer.canvas.height;
            const p = new Uint8Array(4 * w * h); gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p); const seen = new Set(); let sum = 0;
            for (let i = 0; i < p.length; i += 4) { seen.add(p[i] << 16 | p[i + 1] << 8 | p[i + 2]); sum += p[i] + p[i + 1] + p[i + 2]; } return [seen.size, sum / p.length * 4 / 3]; })""")

    def test_every_picture_shows_something(self):
        plain = self.pixels("")
        self.assertGreater(plain[0], 500)
        means = {round(plain[1], 2)}
        for state in ("sa=1", "sa=2", "sa=3", "sa=4", "sa=5", "sa=6", "tilt=40", "strength=0", "exposure=2", "fa=hardware", "a=2"):
            with self.subTest(state):
                colours, mean = self.pixels(state)
                self.assertGreater(colours, 20)
                means.add(round(mean, 2))
                self.assertEqual(self.complaints, [])
        self.assertGreater(len(means), 9, "pictures that are to differ are alike")

    def test_a_point_tells_its_texel(self):
        self.open("bumpy")
        # As on a page that no frame was drawn on yet: a canvas has 300 by 150 pixels wherever it lies.
        self.browser.evaluate("window.shlmViewer.then(viewer => { [viewer.canvas.width, viewer.canvas.height] = [300, 150];"
                              " viewer.probe(viewer.canvas.clientWidth / 2, viewer.canvas.clientHeight * 0.6); })")
        said = self.browser.evaluate("document.getElementById('probe').textContent")
        self.assertRegex(said, r"Texel \d+, \d+ of the atlas, \d+ hits")
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('#probe canvas').length"), 10)  # the nine and an order below
        self.assertEqual(self.complaints, [])

    def test_a_dropped_normal_map_bends(self):
        self.open("bumpy")
        bent = self.browser.evaluate("""window.shlmViewer.then(async viewer => {
            const canvas = new OffscreenCanvas(64, 64), pen = canvas.getContext('2d');
            for (let x = 0; x < 64; ++x) { pen.fillStyle = `rgb(${128 + 100 * Math.sin(x / 5)}, 128, 220)`; pen.fillRect(x, 0, 1, 64); }
            const normals = () => viewer.renderer.measure(viewer.cameraNow(), viewer.lookOf('a'), 64, 36).normal, before = normals();
            await viewer.bendBy(new File([await canvas.convertToBlob()], 'waves.png'));
            const after = normals();
            return after.filter((value, i) => Math.abs(value - before[i]) > 0.05).length; })""")
        self.assertGreater(bent, 200)
        self.assertIn("waves.png", self.browser.evaluate("document.getElementById('said').textContent"))

    def test_another_lit_glb_is_shown(self):
        self.open("bumpy")
        name = self.browser.evaluate("""window.shlmViewer.then(async viewer => {
            await viewer.open(await (await fetch('data:application/octet-stream;base64,%s')).arrayBuffer());
            return [document.getElementById('name').textContent, document.getElementById('test').disabled]; })""" % glb_text(self.root / "cornell" / "lit.glb"))
        self.assertEqual(name, ["cornell", True])
        self.assertIn("no binary glTF", self.browser.evaluate("window.shlmViewer.then(viewer => viewer.open(new ArrayBuffer(100)).catch(error => error.message))"))
        self.assertEqual(self.complaints, [])

    def test_a_scene_that_is_too_large_is_opened_from_its_file(self):
        folder = self.root / "large"
        words = [PROGRAM, "export", SCENE_FOLDER / "bumpy.glb", "--texels", "uv,65536", "--hits", "100000", "--method", "shlm/L4/radiance/bilinear,shlm/L2/radiance/bilinear", "--out", folder]
        subprocess.run([str(word) for word in words], check=True, capture_output=True, timeout=600)
        self.assertGreater((folder / "lit.glb").stat().st_size, 2 * (folder / "viewer.html").stat().st_size)
        result = realtime.compared(self.browser, folder)
        self.assertTrue(result["passed"])
        self.assertEqual(self.complaints, [])

    def test_pictures_of_the_stored_camera(self):
        for state, shown in (("a=%3Dphotonmap/compact/k50/disc", True), ("a=%3Dphotonmap/compact/k50/disc&split=0.5", False)):
            self.open("bumpy", state)
            self.browser.evaluate("window.shlmViewer.then(viewer => viewer.drawNow())")
            self.assertEqual(self.browser.evaluate("!document.getElementById('picture').hidden"), shown)

    def test_keys_walk_and_the_address_remembers(self):
        self.open("bumpy")
        self.browser.evaluate("document.getElementById('scene').focus()")
        self.browser.press("ArrowUp")
        self.assertIn("camera=", self.browser.evaluate("location.hash"))
        eye = self.browser.evaluate("window.shlmViewer.then(viewer => viewer.camera.eye)")
        state = self.browser.evaluate("location.hash.slice(1)")
        self.open("bumpy", state)
        for before, after in zip(eye, self.browser.evaluate("window.shlmViewer.then(viewer => viewer.camera.eye)")):
            self.assertAlmostEqual(before, after, delta=1e-3)

    def test_times_name_what_drew_them(self):
        self.open("cornell")
        result = self.browser.evaluate("window.shlmTimes(1, 96, 54)")
        self.assertTrue(result["software"], result["renderer"])
        self.assertTrue(all(row["fetches"] > 0 for row in result["rows"]))
        plain, order_2 = (next(row for row in result["rows"] if row["choice"] == choice and row["filter"] == "hardware") for choice in ("L0 normalised", "L2 radiance"))
        self.assertEqual((plain["fetches"], order_2["fetches"]), (1, 7))


if __name__ == "__main__":
    PROGRAM, SCENE_FOLDER = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
