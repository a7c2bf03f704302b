"""bench/track from the command line to its history, with programs that only say how long they took: track_test.py"""

import json
import math
import os
import signal
import tempfile
import unittest

from track_fakes import CMAKE, FakeRepository

EVALUATE, GATHER = "sh_evaluate", "gather/shlm/texels:4096/order:image"
TIMES = {EVALUATE: 0.001, GATHER: 0.2}


class TrackTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.fake = FakeRepository(folder.name)

    def records(self):
        (file,) = self.fake.history_files()
        return [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines()]

    def verdicts(self, part="benchmarks"):
        return {name: row["verdict"] for name, row in self.records()[-1][part].items()}


class Comparison(TrackTest):
    def test_equal_revisions_end_with_0_and_teach_the_noise(self):
        base, head = self.fake.commit(TIMES), self.fake.commit(TIMES, instructions=1001)
        code, out, err = self.fake.track(base, head)
        self.assertEqual(code, 0, out + err)
        learnt, compared = self.records()
        self.assertEqual((learnt["base"], learnt["head"]), (base[:12], base[:12]))
        self.assertEqual((compared["base"], compared["head"]), (base[:12], head[:12]))
        self.assertEqual(set(self.verdicts().values()) | set(self.verdicts("errors").values()), {"same"})
        for name in TIMES:
            row = compared["benchmarks"][name]
            self.assertAlmostEqual(row["band"], abs(math.log(learnt["benchmarks"][name]["ratio"])))
            self.assertAlmostEqual(row["base"], TIMES[name], delta=0.02 * TIMES[name])
            self.assertEqual(row["instructions"], [1000, 1001])
            self.assertRegex(out, rf"{name} .* 1\.0010 +same")
        self.assertTrue(learnt["finished"] and compared["finished"])
        # What is learnt is not learnt again.
        self.fake.track(base, head)
        self.assertEqual([record["kind"] for record in self.records()], ["same build twice", "two revisions", "two revisions"])

    def test_speed_bought_with_error_ends_with_1(self):
        base = self.fake.commit(TIMES)
        self.fake.commit({**TIMES, GATHER: TIMES[GATHER] / 1.1}, error=0.11)
        code, out, err = self.fake.track(base)
        self.assertEqual(code, 1, out + err)
        self.assertEqual(self.verdicts(), {EVALUATE: "same", GATHER: "faster"})
        self.assertEqual(self.verdicts("errors"), {"cornell/shlm": "worse", "cornell/photonmap": "worse"})
        low, high = self.records()[-1]["benchmarks"][GATHER]["interval"]
        self.assertTrue(low < 1 / 1.1 < high, (low, high))
        self.assertRegex(out, rf"{GATHER} .* faster")
        self.assertRegex(out, r"cornell/shlm .* worse")

    def test_ten_percent_slower_ends_with_1(self):
        base = self.fake.commit(TIMES)
        self.fake.commit({**TIMES, EVALUATE: TIMES[EVALUATE] * 1.1}, instructions=1001)
        self.assertEqual(self.fake.track(base)[0], 1)
        self.assertEqual(self.verdicts(), {EVALUATE: "slower", GATHER: "same"})

    def test_a_benchmark_that_fails_ends_with_1(self):
        base = self.fake.commit(TIMES)
        self.fake.commit({**TIMES, GATHER: None}, instructions=1001)
        code, out, _ = self.fake.track(base)
        self.assertEqual(code, 1)
        self.assertEqual(self.verdicts(), {EVALUATE: "same", GATHER: "failed"})
        self.assertRegex(out, rf"{GATHER} .* the mean is wrong")

    def test_what_only_one_has_is_named_and_scenes_that_differ_too(self):
        base = self.fake.commit({EVALUATE: 0.001, "old": 1.0})
        self.fake.commit({EVALUATE: 0.001, "new": 1.0}, instructions=1001, scene="another scene")
        code, out, _ = self.fake.track(base)
        self.assertEqual(code, 0)
        self.assertEqual(set(self.verdicts()), {EVALUATE})
        for line in ("not in BASE: new", "not in HEAD: old", "different scenes: cornell.glb"):
            self.assertIn(line, out)

    def test_a_revision_against_itself_only_teaches(self):
        base = self.fake.commit(TIMES)
        for lines in (1, 2):
            self.assertEqual(self.fake.track(base, base, "--filter", "^sh_")[0], 0)
            self.assertEqual([record["kind"] for record in self.records()], lines * ["same build twice"])
        self.assertEqual(self.verdicts(), {EVALUATE: "learnt"})


class Interruption(TrackTest):
    def test_what_is_finished_is_kept(self):
        base = self.fake.commit({EVALUATE: 0.001, GATHER: 0})
        process = self.fake.start(base, base)
        while line := process.stderr.readline():
            if "time 2/2" in line:
                break
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate()
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("interrupted: only what was finished", out)
        (record,) = self.records()
        self.assertFalse(record["finished"])
        self.assertEqual(set(record["benchmarks"]), {EVALUATE})


class BadInput(TrackTest):
    def assert_refused(self, reason, *arguments):
        code, out, err = self.fake.track(*arguments)
        self.assertEqual((code, out), (2, ""), err)
        self.assertRegex(err.splitlines()[-1], reason)
        self.assertNotIn("Traceback", err)

    def test_is_refused(self):
        base = self.fake.commit(TIMES)
        self.assert_refused("nowhere: no such revision", "nowhere")
        self.assert_refused("--upload-pack=x: no such revision", "--", "--upload-pack=x")
        self.assert_refused("even number from 10 on", base, "--pairs", "8")
        self.assert_refused("even number from 10 on", base, "--pairs", "11")
        self.assert_refused("--filter \\(: missing", base, "--filter", "(")
        self.assert_refused("no such benchmark in common", base, base, "--filter", "nothing")
        self.assertEqual(self.fake.history_files(), [])

    def test_changes_without_a_revision_are_refused(self):
        base = self.fake.commit(TIMES)
        (self.fake.folder / "cornell.glb").write_text("changed")
        self.assert_refused("changes that no revision names", base)

    def test_what_does_not_build_is_refused(self):
        broken = self.fake.commit(TIMES, cmake=CMAKE + "message(FATAL_ERROR)")
        self.assert_refused("does not build, see .*native.log", broken, broken)

    def test_another_machines_history_is_not_compared_with(self):
        base = self.fake.commit(TIMES)
        self.fake.track(base, base, "--filter", "^sh_")
        (file,) = self.fake.history_files()
        record = json.loads(file.read_text(encoding="utf-8"))
        record["machine"]["name"] = "another"
        # In this machine's file: refused.
        file.write_text(json.dumps(record) + "\n", encoding="utf-8")
        self.assert_refused("line 1: measured on another, this machine is .*: they are not compared", base, base)
        # In its own file: not read.
        file.rename(file.with_name("another.jsonl"))
        code, _, err = self.fake.track(base, base, "--filter", "^sh_")
        self.assertEqual(code, 0, err)
        self.assertIn("not compared with what other machines measured: another", err)


if __name__ == "__main__":
    unittest.main()
