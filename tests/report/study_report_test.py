"""The study's whole report, on synthetic studies whose errors are known. Bounds on random quantities come from SIGNIFICANCE."""

import contextlib
import io
import json
import math
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.study import report as study_report
from report.study.curves import curves_of
from report.study.data import Study, StudyError
from report.study.images import same_bytes, same_time
from study_laws import (
    FOUR_METHODS,
    PHOTONS,
    SHLM,
    SIGNIFICANCE,
    Folder,
    fixed_k_law,
    light_map_law,
    radius_law,
    z_for,
)
from synthetic_study import CONTEXT, REFERENCE_VARIANCE, Plan, write_json, write_study
from known_methods import facts_of


class Reports(Folder):
    def report(self):
        """(exit code, stdout, stderr) of `bench/report study` on the folder."""
        out, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            code = study_report.main([str(self.folder)])
        return code, out.getvalue(), errors.getvalue()

    def test_whole_report(self):
        methods = {
            SHLM: light_map_law(),
            "shlm/L0/normalised/surface4": light_map_law(4e-4),
            "shlm/L2/radiance/surface4/t16384": light_map_law(1e-3, 100),
            PHOTONS: fixed_k_law(),
            "photonmap/compact/r0.01/disc": radius_law(),
        }
        plan = Plan(methods, scenes=("bumpy",), sizes=(10_000, 1_000_000), seeds=3, has_pictures=True)
        truth = write_study(self.folder, plan)["bumpy"]
        code, out, errors = self.report()
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual(sum(line.startswith("bumpy: 10 %: ") for line in out.splitlines()), 1)
        summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        scene = summary["scenes"]["bumpy"]
        self.assertEqual(summary["problems"], [])
        # The reference on disk is off by a thousandth at each value, and so are eps and the weights at most.
        bound = 2 * z_for(SIGNIFICANCE) * math.sqrt(REFERENCE_VARIANCE)
        self.assertAlmostEqual(scene["epsilon"] / truth.epsilon, 1, delta=bound)
        self.assertAlmostEqual(scene["reference_error_sq"] / REFERENCE_VARIANCE, 1, delta=bound)
        self.assertEqual(scene["seconds_to_reach"]["0.05"][PHOTONS]["kind"], "never")
        tilted = scene["methods"][SHLM][0]["tilt"]
        self.assertEqual([t["degrees"][0] for t in tilted], [0, 10, 20, 30, 40, 50, 60])
        text = (self.folder / "report.md").read_text(encoding="utf-8")
        self.assertIn("| 250\u00a0ms | 3\u00a0MiB |", text)  # once a scene
        self.assertIn("## Who reaches an error first", text)
        self.assertIn("## Where the light map is more accurate at equal hits", text)
        self.assertIn("| hits | bumpy |", text)
        for name in (
            "best",
            "time-methods",
            "bytes-shlm",
            "hits-photonmap",
            "split-methods",
            "phases",
            "gather-methods",
            "tilt",
        ):
            self.assertTrue((self.folder / "charts" / f"{name}.png").exists(), name)
            self.assertIn(f"charts/{name}.png", text)
        self.assertIn("images/bumpy-same-time.png", text)
        self.assertTrue((self.folder / "images" / "bumpy-same-bytes.png").exists())
        for word in (CONTEXT["commit"], "3 seeds", "95 %", "2 threads", "eps = 0.01"):
            self.assertIn(word, text)

    def test_study_that_stopped_halfway(self):
        def seeds(method, hits):
            return (
                0
                if hits == 1_000_000 and method != SHLM
                else 1 if hits == 1_000_000 else 2 if method == PHOTONS else 3
            )

        methods = {SHLM: light_map_law(), PHOTONS: fixed_k_law()}
        write_study(
            self.folder, Plan(methods, sizes=(10_000, 100_000, 1_000_000), seeds_of=seeds, points=200)
        )
        document = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        rows, entries = document["rows"], document["scenes"]
        (self.folder / rows[0]["answers"]).unlink()
        with open(self.folder / rows[1]["answers"], "r+b") as file:
            file.truncate(100)
        rows.append(
            {"scene": "cornell", **facts_of(PHOTONS), "hits_asked": 1_000_000, "skipped": "needs 12 GiB"}
        )
        rows.append(
            {"scene": "atrium", **facts_of(SHLM), "hits_asked": 10_000, "seed": 1, "answers": "nowhere"}
        )
        entries["atrium"] = {"points": 10, "raw": "raw/atrium", "reference": "atrium.exr"}
        write_json(self.folder, rows, entries)
        code, out, errors = self.report()
        self.assertEqual((code, errors), (0, ""))
        text = (self.folder / "report.md").read_text(encoding="utf-8")
        self.assertIn("skipped: needs 12 GiB", text)
        summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual(list(summary["scenes"]), ["cornell"])
        self.assertEqual(len(summary["problems"]), 3)  # a scene without a reference, two answers
        points = summary["scenes"]["cornell"]["methods"][SHLM]
        self.assertEqual([p["seeds"] for p in points], [1, 3, 1])
        self.assertIsNone(points[-1]["error_band"])
        self.assertIsNone(points[-1]["bias_sq"])

    def test_budgets_of_the_pictures(self):
        sizes = (10_000, 100_000, 1_000_000, 10_000_000)  # the last is over both budgets
        write_study(self.folder, Plan(FOUR_METHODS, sizes=sizes, seeds=1, points=100))
        curves = curves_of(Study(self.folder))["cornell"]
        self.assertEqual(same_time(curves).largest_within(curves[SHLM]).hits, 1_000_000)
        # 32e6 bytes: the photon map of a million hits is the first that is no smaller.
        smaller = same_bytes(curves)
        self.assertEqual(smaller.limit, 73e6)
        self.assertEqual(smaller.largest_within(curves[PHOTONS]).hits, 1_000_000)

    def test_bad_input_is_one_line(self):
        for content in (None, "{", '{"context": {}, "scenes": {}, "rows": []}', '{"rows": []}'):
            if content is not None:
                (self.folder / "study.json").write_text(content, encoding="utf-8")
            code, out, errors = self.report()
            self.assertEqual((code, out, errors.count("\n")), (2, "", 1), errors)
            self.assertFalse((self.folder / "report.md").exists())

    def test_a_reference_that_contradicts_its_files(self):
        write_study(self.folder, Plan({SHLM: light_map_law()}, sizes=(10_000,), seeds=1, points=50))
        document = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        document["scenes"]["cornell"]["reference_error"] = 0.5
        write_json(self.folder, document["rows"], document["scenes"])
        self.assertEqual(len(Study(self.folder).problems), 1)

    def test_missing_study(self):
        with self.assertRaises(StudyError):
            Study(self.folder / "nowhere")


if __name__ == "__main__":
    unittest.main()
