"""How often fit keeps its word, counted on fits that are made up: promise_test.py"""

import contextlib
import io
import json
import stat
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.fit import promise
from report.fit.promise_rows import rows_of, summary_of, table_of

PROGRAM = """#!/usr/bin/python3
import json, sys
from pathlib import Path
words = sys.argv[1:]
if words[0] == "reference":
    Path(words[words.index("--out") + 1]).write_text("")
    sys.exit()
room = int(Path(words[1]).stem.split("-")[1])
out = Path(words[words.index("--out") + 1])
def entry(error):
    return {"reached": True, "sure": True, "choice": {"method": "shlm", "hits": 1, "error": 0.09, "bound": 0.1, "noise": 0.05, "seconds": 2},
            "verified": [{"error": error}] * 10}
fit = {"scene": f"room-{room}", "target": 0.1, "context": {"machine": "m"}, "reference_error": 0, "pilot": {"seconds": 4},
       "light_map": entry(0.09), "photon_map": entry(ERROR)}
out.mkdir(parents=True)
(out / "fit.json").write_text(json.dumps(fit))
"""
MAKER = """#!/usr/bin/python3
import sys
from pathlib import Path
Path(sys.argv[1]).mkdir(parents=True, exist_ok=True)
Path(sys.argv[1], sys.argv[2] + ".glb").write_text("")
"""


def entry(measured, sure=True, estimated=0.09):
    runs = [{"error": error} for error in measured]
    choice = {"method": "shlm", "hits": 1e5, "error": estimated, "bound": 0.1, "noise": 0.05, "seconds": 0.5}
    return {"reached": True, "sure": sure, "choice": choice, "verified": runs} | ({} if sure else {"doubt": "chance"})


def fit_of(light_map, photon_map, reference_error=0.0):
    return {"scene": "room-7", "target": 0.1, "reference_error": reference_error, "pilot": {"seconds": 2.0}, "context": {},
            "light_map": light_map, "photon_map": photon_map}


class Counting(unittest.TestCase):
    def summary(self, *fits):
        return summary_of(rows_of(fits))

    def test_runs_are_counted_by_whether_fit_was_sure(self):
        found = self.summary(fit_of(entry([0.09, 0.11]), entry([0.12, 0.12], sure=False)))
        self.assertEqual((found["sure"]["runs"], found["sure"]["runs_that_meet"]), (2, 1))
        self.assertEqual((found["not_sure"]["runs"], found["not_sure"]["runs_that_meet"]), (2, 0))
        self.assertEqual(found["sure"]["pilot_over_chosen"], 4)

    def test_the_references_own_error_is_taken_off(self):
        found = self.summary(fit_of(entry([0.104]), entry([0.104]), reference_error=0.03))
        self.assertEqual(found["sure"]["runs_that_meet"], 2)
        self.assertAlmostEqual(found["sure"]["measured_over_estimated"]["median"], (0.104**2 - 0.03**2) ** 0.5 / 0.09)

    def test_how_much_of_the_margin_runs_use(self):
        half = (0.5 * (0.09**2 + 0.1**2)) ** 0.5
        found = self.summary(fit_of(entry([half] * 10), entry([half] * 10)))
        self.assertAlmostEqual(found["sure"]["used_margin"]["nine_tenths"], 0.5)
        self.assertAlmostEqual(found["sure"]["used_margin"]["at_most"], 0.5)

    def test_what_is_out_of_reach_is_counted_apart(self):
        nothing = {"reached": False, "sure": True, "reason": "bias"}
        found = self.summary(fit_of(entry([0.09]), nothing))
        self.assertEqual((found["out_of_reach"], found["sure"]["choices"]), (1, 1))
        text = table_of({"summary": found, "rooms": {"first": 7, "count": 1}, "context": {}})
        self.assertIn("choices out of reach: 1", text)


class Running(unittest.TestCase):
    def run_with(self, error):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("program", PROGRAM.replace("ERROR", str(error))), ("maker", MAKER)):
                Path(folder, name).write_text(text)
                Path(folder, name).chmod(stat.S_IRWXU)
            out = Path(folder, "out")
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                code = promise.main([f"{folder}/program", f"{folder}/maker", str(out), "--rooms", "3,2"])
            return code, json.loads((out / "promise.json").read_text()), (out / "promise.png").exists()

    def test_the_exit_code_says_whether_nine_of_ten_meet(self):
        code, document, drawn = self.run_with(0.095)
        self.assertEqual((code, document["summary"]["sure"]["runs"], drawn), (0, 40, True))
        self.assertEqual(self.run_with(0.11)[0], 1)

    def test_bad_input_is_one_line(self):
        for rooms in ("x", "1", "1,0"):
            errors = io.StringIO()
            with contextlib.redirect_stderr(errors), tempfile.TemporaryDirectory() as folder:
                self.assertEqual(promise.main(["p", "m", folder, "--rooms", rooms]), 2)
            self.assertEqual(errors.getvalue().count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
