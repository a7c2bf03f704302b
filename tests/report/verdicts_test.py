"""One table of verdicts from several results: verdicts_test.py"""

import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from claims_test import row, summary
from report.claims import verdicts
from report.compare.comparison import INCREMENTAL, LIGHT_MAP, PAPER_LIGHT_MAP, PHOTON_MAP


class OneTable(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)

    def folder(self, name, rows=None, study=None, machine="a machine"):
        (self.root / name).mkdir()
        if rows:
            (self.root / name / "compare.json").write_text(json.dumps({"context": {"machine": machine}, "rows": rows}))
        if study:
            study["context"]["machine"] = machine
            (self.root / name / "summary.json").write_text(json.dumps(study))
        return self.root / name

    def rows_of(self, *folders):
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(verdicts.main([str(self.root / "verdicts.md"), *map(str, folders)]), 0)
        self.text = (self.root / "verdicts.md").read_text()
        return {row["claim"]: row for row in json.loads((self.root / "verdicts.json").read_text())}

    def timed(self, light_map=LIGHT_MAP, photons=5.0, **facts):
        return [row(light_map, 1000, **facts)] + [row(m, 1000, build_seconds=photons, **facts) for m in (INCREMENTAL, PHOTON_MAP)]

    def test_a_row_says_what_it_rests_on(self):
        found = self.rows_of(self.folder("quick", self.timed()))["tracing-speed"]
        self.assertEqual(found["verdict"], "confirmed")
        self.assertEqual(found["rests_on"], [f"quick: 1 scene (room), 5 runs, {LIGHT_MAP}, a machine"])
        self.assertEqual(found["link"], "quick/report.md")
        self.assertIn("x at 1 k hits", found["figure"])
        self.assertEqual(found["findings"]["quick"]["ratios"]["the strongest engine"], {"1000": [7 / 3, 7 / 3]})
        self.assertIn("| [tracing-speed](quick/report.md) |", self.text)

    def test_what_nobody_measured_is_not_there(self):
        found = self.rows_of(self.folder("quick", self.timed()))
        self.assertNotIn("converges", found)
        self.assertNotIn("not measured yet", self.text)

    def test_folders_that_differ_make_it_conditional(self):
        quick, slow = self.folder("quick", self.timed()), self.folder("slow", self.timed(photons=0.1), machine="another")
        found = self.rows_of(quick, slow)["tracing-speed"]
        self.assertEqual(found["verdict"], "conditional")
        self.assertIn("In quick: holds.", found["condition"])
        self.assertIn("In slow: fails.", found["condition"])
        self.assertEqual(len(found["rests_on"]), 2)

    def test_a_folder_that_decides_nothing_does_not_count(self):
        quick, once = self.folder("quick", self.timed()), self.folder("once", self.timed(photons=0.1, repetitions=1))
        found = self.rows_of(quick, once)["tracing-speed"]
        self.assertEqual(found["verdict"], "confirmed")
        self.assertIn("In once: not decided.", found["condition"])
        self.assertEqual(found["link"], "quick/report.md")

    def test_the_papers_light_map_where_the_default_was_not_measured(self):
        found = self.rows_of(self.folder("old", self.timed(PAPER_LIGHT_MAP)))["tracing-speed"]
        self.assertIn(PAPER_LIGHT_MAP, found["rests_on"][0])

    def test_a_study_decides_its_claims(self):
        point = {"hits": 1e6, "seeds": 8, "error": 0.01, "variance": 0.01, "bias_sq": 1e-4, "bias_sq_band": [-1e-4, 3e-4], "tilt": []}
        found = self.rows_of(self.folder("study", study=summary({LIGHT_MAP: [point]})))
        self.assertEqual(found["converges"]["verdict"], "confirmed")
        self.assertIn("8 runs", found["converges"]["rests_on"][0])
        point["seeds"] = 1
        once = self.rows_of(self.folder("once", study=summary({LIGHT_MAP: [point]})))
        self.assertEqual(once["converges"]["verdict"], "not decided")

    def test_refuses_folders_without_results(self):
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(verdicts.main([str(self.root / "verdicts.md"), str(self.folder("empty"))]), 2)
        self.assertIn("no folder", errors.getvalue())
        self.assertFalse((self.root / "verdicts.md").exists())


if __name__ == "__main__":
    unittest.main()
