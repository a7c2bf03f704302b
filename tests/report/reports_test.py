"""bench/report as a program: each report that it lists is there, and a wrong name is one line."""

import importlib
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
FOLDER = Path(__file__).resolve().parents[2] / "bench"
sys.path.insert(0, str(FOLDER))

from report.__main__ import REPORTS


def run(*words):
    return subprocess.run([sys.executable, str(FOLDER / "report"), *words], capture_output=True, text=True)


class Reports(unittest.TestCase):
    def test_all_are_there(self):
        for name, (module, *_) in REPORTS.items():
            self.assertTrue(callable(importlib.import_module(module).main), name)

    def test_help_names_all(self):
        done = run("--help")
        self.assertEqual(done.returncode, 0)
        for name in REPORTS:
            self.assertIn(f"\n  {name} ", done.stdout)

    def test_options_of_a_report_are_its_own(self):
        done = run("elsewhere", "--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("--methods", done.stdout)

    def test_wrong_names_are_one_line(self):
        for words in ([], ["no-such-report"], *([name] for name in REPORTS), ["study", "/nonexistent"], ["fit-search", "/nonexistent"]):
            done = run(*words)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), words)


if __name__ == "__main__":
    unittest.main()
