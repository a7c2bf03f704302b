"""Figures in texts and the data they are from: figures_test.py"""

import contextlib
import io
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

from report import figures

DATA = {"rows": [{"method": "shlm/L2", "hits": 1000000, "seconds": 0.0234, "error": 0.0025}, {"method": "photonmap", "hits": 1000000, "seconds": 0.0468, "by": {"a/b": -0.5, "c d": 0.25}}]}


class Figures(unittest.TestCase):
    def problems(self, text):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "data.json").write_text(json.dumps(DATA))
            Path(folder, "table.md").write_text("| a |\n|---|\n| 1 |\n")
            file = Path(folder, "text.md")
            file.write_text(text)
            figures.data_of.cache_clear()
            return figures.stale_in(file)[0]

    def test_a_figure_is_its_data_as_far_as_it_is_printed(self):
        path = "<!-- =data.json rows/[method=shlm/L2,hits=1e6]/seconds"
        for number, unit in (("0.0234", ""), ("0.023", ""), ("23", " ms"), ("23.4", " ms"), ("0.5", " /rows/[method=photonmap]/seconds")):
            self.assertEqual(self.problems(f"It takes {number} s{path}{unit} -->."), [], number)
        for number, unit in (("0.0235", ""), ("0.024", ""), ("24", " ms"), ("0.6", " /rows/[method=photonmap]/seconds")):
            (problem,) = self.problems(f"It takes\n{number} s{path}{unit} -->.")
            self.assertIn("text.md:2:", problem)

    def test_a_marker_belongs_to_the_last_number_before_it(self):
        self.assertEqual(self.problems("Of rooms 1 to 24, 1000000<!-- =data.json rows/0/hits --> hits."), [])

    def test_signs_count(self):
        marker = "<!-- =data.json rows/1/by/[a/b] -->"
        self.assertEqual(self.problems(f"It is -0.5{marker}."), [])
        self.assertEqual(self.problems("It is 25 %<!-- =data.json rows/1/by/c d % -->."), [])
        self.assertEqual(len(self.problems(f"It is 0.5{marker}, +0.5{marker}, 1-0.5{marker}.")), 3)

    def test_squares_are_read_as_errors(self):
        self.assertEqual(self.problems("5 %<!-- =data.json rows/0/error root% -->"), [])
        self.assertEqual(len(self.problems("6 %<!-- =data.json rows/0/error root% -->")), 1)

    def test_ends_of_a_range_are_found_among_all(self):
        for number, words in (("0.023", "least rows/*/seconds"), ("0.047", "most rows/[hits=1e6]/seconds"), ("46.8", "most rows/*/seconds ms"),
                              ("0.0025", "least rows/*/error"), ("2.0", "most rows/[method=photonmap]/seconds /rows/[method=shlm/L2]/seconds")):
            self.assertEqual(self.problems(f"{number}<!-- =data.json {words} -->"), [], words)
        for number, words in (("0.05", "least rows/*/seconds"), ("0.023", "rows/*/seconds"), ("1", "least rows/*/none"), ("2", "most rows/*/seconds /rows/0/seconds")):
            self.assertEqual(len(self.problems(f"{number}<!-- =data.json {words} -->")), 1, words)

    def test_what_is_not_there_is_stale(self):
        for marker in ("none.json x", "data.json rows/[method=none]/hits", "data.json rows/[hits=1e6]/seconds", "data.json rows/0/none",
                       "data.json rows/9/hits", "data.json rows", "data.json rows/0/hits furlongs"):
            self.assertEqual(len(self.problems(f"1<!-- ={marker} -->")), 1, marker)

    def test_stale_figures_are_written_anew_as_they_were_printed(self):
        for old, marker, new in (("0.9", "seconds", "0.0"), ("99.9", "seconds ms", "23.4"), ("7", "seconds ms", "23"), ("0.0235", "seconds", "0.0234"),
                                 ("2,000,000", "hits", "1,000,000"), ("3", "none", "3"), ("1.5e5", "hits", "1.0e6"), ("23.40", "seconds ms", "23.40")):
            with tempfile.TemporaryDirectory() as folder:
                Path(folder, "data.json").write_text(json.dumps(DATA))
                file = Path(folder, "text.md")
                mark = f"<!-- =data.json rows/0/{marker} -->"
                file.write_text(f"From 1 to {old} s{mark}, and so on.\n")
                figures.data_of.cache_clear()
                figures.write_anew(file)
                self.assertEqual(file.read_text(), f"From 1 to {new} s{mark}, and so on.\n")

    def test_a_copy_is_word_for_word(self):
        def copy(number):
            return f"<!-- copy of table.md -->\n| a |\n|---|\n| {number} |\n<!-- end of copy -->\n"

        self.assertEqual(self.problems(copy(1)), [])
        self.assertEqual(len(self.problems(copy(2))), 1)

    def test_whole_numbers_may_be_rounded(self):
        self.assertEqual(self.problems("1,000,000<!-- =data.json rows/0/hits -->"), [])
        self.assertEqual(figures.half_of_last_digit("27300"), 50)


def own_texts():
    """All that have a marker, but what is measured anew at will."""
    folders = [ROOT / name for name in ("results", "bench", "shlm", "photonmap", "common")]
    texts = [*ROOT.glob("*.md"), *(file for folder in folders for file in sorted(folder.rglob("*.md")))]
    marked = [file for file in texts if re.search("<!-- (=|copy of )", file.read_text(encoding="utf-8"))]
    return [file for file in marked if ROOT / "results" / "latest" not in file.parents]


class OwnTexts(unittest.TestCase):
    def test_no_figure_is_stale(self):
        texts = own_texts()
        self.assertIn(ROOT / "results" / "models" / "README.md", texts)
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(figures.main([str(file) for file in texts]), 0, errors.getvalue())
        self.assertEqual(errors.getvalue(), "")

    def test_machines_and_commits_are_those_of_the_data(self):
        text = (ROOT / "results" / "README.md").read_text(encoding="utf-8")
        table = re.search(r"^\| measured in \| machine \| commit \|\n\|[-|]+\|\n((?:\|.*\n)+)", text, flags=re.MULTILINE)[1]
        for row in table.splitlines():
            folder, machine, commit = (cell.strip() for cell in row.strip("|").split("|"))
            data = [file.read_text(encoding="utf-8") for file in sorted((ROOT / "results" / folder).glob("*.json"))]
            self.assertTrue(any(f'"machine": "{machine}"' in one and f'"commit": "{commit}' in one for one in data), row)


if __name__ == "__main__":
    unittest.main()
