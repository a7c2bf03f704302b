"""Callgrind counts what Google Benchmark times, no more: track_counts_test.py SUBJECT, SUBJECT being tests/report/track_subject.cpp's program"""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench" / "tracking"))

import instructions
from process import MeasurementFailed

SUBJECT = sys.argv.pop()
MOST_BESIDE = 3000  # instructions of Google Benchmark's own and of clocks, far below the million rounds that are paused


class Counts(unittest.TestCase):
    def count(self, name):
        with tempfile.TemporaryDirectory() as folder:
            return instructions.count(SUBJECT, name, Path(folder) / "callgrind.out")

    def test_a_loop_of_nine_to_eleven_instructions(self):
        per_round = (self.count("plain/101000") - self.count("plain/1000")) / 100_000
        # Add, compare and branch, as the compiler joins them, or two rounds in one.
        self.assertTrue(9 <= per_round <= 11, per_round)
        self.assertLess(self.count("plain/1000"), 1000 * per_round + MOST_BESIDE)

    def test_what_is_paused_is_not_counted(self):
        for rounds in (1_000, 101_000):
            self.assertAlmostEqual(self.count(f"paused/{rounds}"), self.count(f"plain/{rounds}"), delta=MOST_BESIDE)

    def test_a_failure_is_told(self):
        with self.assertRaisesRegex(MeasurementFailed, "as it should"):
            self.count("failing")


if __name__ == "__main__":
    unittest.main()
