"""bench/track's reckoning, on made-up times with known answers: track_statistics_test.py"""

import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path[:0] = [str(BENCH / "tracking"), str(BENCH)]

import history
import instructions
import interval
import machine
import micro
from alternation import alternate, order
from input_error import InputError
from process import MeasurementFailed

PAIRS = 10
MOST_DEVIATIONS = 4  # of a binomial count above its mean: chance 3e-5


def quiet(generator, shape):
    return np.exp(0.01 * generator.normal(size=shape))


def with_other_work(generator, shape):
    """One run in ten is slower by up to 30 %."""
    return quiet(generator, shape) * (1 + 0.3 * generator.random(shape) * (generator.random(shape) < 0.1))


def second_of_a_pair_is_faster(generator, shape):
    times = quiet(generator, (2, *shape))
    for pair, (_, second) in enumerate(order(shape[1])):
        times[second, :, pair] *= 0.98
    return times


def most_by_chance(trials, rate):
    return trials * rate + MOST_DEVIATIONS * math.sqrt(trials * rate * (1 - rate))


def alarms(base, head, comparisons):
    return sum(interval.side(interval.ratio(b, h, comparisons), 0.0) != 0 for b, h in zip(base, head))


class FalseAlarms(unittest.TestCase):
    def test_one_comparison_keeps_its_confidence(self):
        trials = 3000
        for times in (quiet, with_other_work):
            generator = np.random.default_rng(1)
            shape = (trials, PAIRS)
            seen = alarms(times(generator, shape), times(generator, shape), 1)
            self.assertLessEqual(seen, most_by_chance(trials, 1 - interval.CONFIDENCE), times.__name__)

    def test_a_whole_table_keeps_it_too(self):
        tables, benchmarks = 100, 40
        generator = np.random.default_rng(2)
        shape = (benchmarks, PAIRS)
        seen = sum(alarms(quiet(generator, shape), quiet(generator, shape), benchmarks) > 0 for _ in range(tables))
        self.assertLessEqual(seen, most_by_chance(tables, 1 - interval.CONFIDENCE))

    def test_the_order_within_pairs_cancels(self):
        trials = 1000
        times = second_of_a_pair_is_faster(np.random.default_rng(3), (trials, PAIRS))
        self.assertLessEqual(alarms(times[0], times[1], 1), most_by_chance(trials, 1 - interval.CONFIDENCE))


class Detection(unittest.TestCase):
    def test_ten_percent_are_found_among_forty_benchmarks(self):
        """The interval's half width is about 4.8 sqrt(2 / 10) 1 % = 2.1 %, its standard error a fifth of what is left."""
        generator = np.random.default_rng(4)
        for factor, side in ((1.1, 1), (1 / 1.1, -1)):
            for _ in range(200):
                base, head = quiet(generator, PAIRS), factor * quiet(generator, PAIRS)
                self.assertEqual(interval.side(interval.ratio(base, head, 40), 0.0), side)

    def test_the_ratio_is_head_over_base(self):
        found = interval.ratio([1.0] * PAIRS, [1.25] * PAIRS, 3)
        for value in (found.value, found.low, found.high):
            self.assertAlmostEqual(value, 1.25)

    def test_two_slow_runs_do_not_move_it(self):
        head = [1.0] * 8 + [50.0, 90.0]
        self.assertAlmostEqual(interval.ratio([1.0] * PAIRS, head, 1).value, 1.0)

    def test_a_difference_within_the_band_is_none(self):
        found = interval.Ratio(1.05, 1.04, 1.06)
        self.assertEqual(interval.side(found, math.log(1.039)), 1)
        self.assertEqual(interval.side(found, math.log(1.041)), 0)
        inverse = interval.Ratio(1 / 1.05, 1 / 1.06, 1 / 1.04)
        self.assertEqual(interval.side(inverse, math.log(1.039)), -1)
        self.assertEqual(interval.side(inverse, math.log(1.041)), 0)


class Order(unittest.TestCase):
    def test_abba(self):
        seen = []
        values = alternate(lambda program: seen.append(program) or len(seen), "AB", 4)
        self.assertEqual("".join(seen), "ABBAABBA")
        self.assertEqual(values, ([1, 4, 5, 8], [2, 3, 6, 7]))

    def test_a_drift_meets_both_alike(self):
        clock = iter(range(1000))
        base, head = alternate(lambda _: next(clock), "AB", PAIRS)
        self.assertEqual(sum(base), sum(head))


class History(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = machine.this_machine()
        self.file = history.history_file(Path(folder.name), self.here)

    def record(self, kind, **ratios):
        return {"kind": kind, "machine": self.here, "benchmarks": {name: {"ratio": ratio} for name, ratio in ratios.items()}}

    def test_lines_come_back(self):
        self.assertEqual(history.read(self.file, self.here), [])
        records = [self.record(history.SAME, a=1.01), self.record(history.TWO, a=2.0)]
        for record in records:
            history.append(self.file, record)
        self.assertEqual(history.read(self.file, self.here), records)

    def test_does_not_say_where_the_repository_lies(self):
        failed = {"verdict": "failed", "because": f"{self.file.parents[2]}/build/track/image.png is broken"}
        history.append(self.file, self.record(history.TWO) | {"errors": {"cornell/shlm": failed}})
        (kept,) = history.read(self.file, self.here)
        self.assertEqual(kept["errors"]["cornell/shlm"]["because"], "build/track/image.png is broken")

    def test_another_machine_is_refused(self):
        history.append(self.file, self.record(history.SAME, a=1.01))
        history.append(self.file, self.record(history.SAME, a=1.01) | {"machine": {**self.here, "name": "another"}})
        with self.assertRaisesRegex(InputError, "line 2: measured on another"):
            history.read(self.file, self.here)

    def test_what_is_no_comparison_is_refused(self):
        for line in ("{", "[]", '"text"', json.dumps({"machine": 1})):
            self.file.parent.mkdir(parents=True, exist_ok=True)
            self.file.write_text(line + "\n", encoding="utf-8")
            with self.assertRaisesRegex(InputError, "line 1: not a comparison"):
                history.read(self.file, self.here)

    def test_the_band_is_the_largest_difference_of_equal_builds(self):
        bands = history.noise_bands(
            [
                self.record(history.SAME, a=1.01, b=1.0),
                self.record(history.SAME, a=0.98),
                self.record(history.TWO, a=3.0, c=3.0),
                {"kind": history.SAME, "benchmarks": {"d": {"verdict": "failed"}}},
            ]
        )
        self.assertEqual(set(bands), {"a", "b"})
        self.assertAlmostEqual(bands["a"], math.log(1 / 0.98))
        self.assertEqual(bands["b"], 0.0)


class Instructions(unittest.TestCase):
    PAUSE = "--dump-before=benchmark::State::PauseTiming()"

    @staticmethod
    def dumps(*parts):
        return "version: 1\n" + "".join(
            f"part: {n}\ndesc: Timerange: 0 - 1\ndesc: Trigger: {trigger}\nevents: Ir\nsummary: {count}\n0 7\ntotals: 99\n"
            for n, (trigger, count) in enumerate(parts, 1)
        )

    def test_what_lies_between_pauses_is_added_up_to_the_end(self):
        text = self.dumps((self.PAUSE, 100), (self.PAUSE, 50), (instructions.END, 7), (self.PAUSE, 20), ("Program termination", 1000))
        self.assertEqual(instructions.counted(text), 157)

    def test_a_loop_without_end_is_refused(self):
        for text in (self.dumps(("Program termination", 5)), self.dumps((instructions.END, 5), (instructions.END, 5))):
            with self.assertRaises(MeasurementFailed):
                instructions.counted(text)

    def test_large_and_threaded_ones_are_left_out(self):
        self.assertTrue(instructions.is_countable("sh_evaluate"))
        self.assertTrue(instructions.is_countable("trace/null_sink/hits:100000/threads:1/real_time"))
        for name in ("trace/hits:1000000/threads:1", "trace/hits:10000/threads:2", "build/shlm/texels:262144/real_time"):
            self.assertFalse(instructions.is_countable(name), name)


class Filter(unittest.TestCase):
    def test_a_name_matches_itself_alone(self):
        self.assertEqual(micro.exactly("a/b:1.5(x)"), r"--benchmark_filter=^a/b:1\.5\(x\)$")


if __name__ == "__main__":
    unittest.main()
