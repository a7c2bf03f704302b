"""What stands in for the truth in a fit, where the truth is known."""

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.fit import truth as fit_truth
from report.study.data import Study, StudyError
from synthetic_study import Law, Plan, write_study

FINE, COARSE, BLURRED = "shlm/L4/radiance/own/t4096/h0", "shlm/L4/radiance/own/t1024/h0", "photonmap/compact/r0.1/disc"


def law(bias):
    """All have the same pattern: of biases 1, 2 and 4, that of the third is 4 - 1 by the first."""
    return Law(variance=lambda n: 1 / n, bias_sq=lambda n: bias**2)


class FitTruth(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        write_study(cls.folder, Plan({FINE: law(0.01), COARSE: law(0.02), BLURRED: law(0.04)}))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_is_halfway_between_the_finest_map_and_its_extrapolation(self):
        study = Study(self.folder)
        rows = fit_truth.rows_of(
            study.scenes["cornell"], fit_truth.runs_with_most_hits(study, "cornell"), FINE, COARSE
        )
        found = {method: squares for method, *squares in rows}
        of_all = {FINE: (1, 1, 1, 1.5), COARSE: (4, 2, 4, 3.5), BLURRED: (16, 10, 16, 13.5)}
        for method, squares in of_all.items():
            for got, wanted in zip(found[method], squares, strict=True):
                # The reference's noise and the answers', both 1e-3 or less, over 600 points and three channels.
                self.assertAlmostEqual(1e4 * got, wanted, delta=0.1 * wanted)

    def test_needs_both_maps(self):
        with self.assertRaisesRegex(StudyError, "no x for cornell"):
            fit_truth.table(Study(self.folder), "cornell", "x", COARSE)
        with self.assertRaisesRegex(StudyError, "no scene attic"):
            fit_truth.table(Study(self.folder), "attic", FINE, COARSE)

    def test_refuses_what_is_no_study(self):
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(fit_truth.main(["/nonexistent", "cornell", FINE, COARSE]), 2)
        self.assertEqual(len(errors.getvalue().splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
