"""The texts that people read first: short sentences, links that lead somewhere, a row for all that registers itself. texts_test.py"""

import re
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / ".ci" / "words"
sys.path.insert(0, str(ROOT / "bench"))

from report.__main__ import REPORTS


def loaded(path):
    loader = SourceFileLoader("words", str(path))
    module = module_from_spec(spec_from_loader("words", loader))
    loader.exec_module(module)
    return module


words = loaded(SCRIPT)


def sentence(count):
    return " ".join(["word"] * count) + "."


class Words(unittest.TestCase):
    def offenders(self, text, name="text.md"):
        return words.offenders_in(name, text)

    def test_a_long_sentence_is_named_with_its_line(self):
        # Short sentences beside it, so that the average is within its bound.
        text = f"Short.\n\n{sentence(3)}\n{sentence(40)} {sentence(3)} {sentence(41)} {sentence(3)}\n"
        (offender,) = self.offenders(text)
        self.assertTrue(offender.startswith("text.md:3: a sentence of 41 words, at most 40: word word"), offender)

    def test_a_long_average_is_an_offence_without_a_long_sentence(self):
        (offender,) = self.offenders(f"{sentence(26)} {sentence(25)}\n")
        self.assertIn("25.5 words a sentence on average", offender)
        self.assertEqual(self.offenders(f"{sentence(26)} {sentence(24)}\n"), [])

    def test_items_and_paragraphs_end_sentences(self):
        half = sentence(24).rstrip(".")
        self.assertEqual(self.offenders(f"{half}\n\n{half}\n\n- {half}\n- {half}\n1. {half}\n"), [])
        for joined in (f"{half}\n{half}\n", f"- {half}\n  {half}\n", f"**{half}** {half}\n"):
            self.assertTrue(any("a sentence of 48 words" in offender for offender in self.offenders(joined)), joined)

    def test_points_within_numbers_and_names_end_none(self):
        self.assertEqual(len(words.sentences_of("It has 0.5 % in file.md and 1:2 of it. So (it is.) And *this!* Is it? Here: one")), 5 + 1)

    def test_a_cell_is_its_own_text(self):
        row = " | ".join([sentence(20)] * 4)
        self.assertEqual(self.offenders(f"| a | b | c | d |\n|---|---|---|---|\n| {row} |\n"), [])
        (offender,) = self.offenders(f"| a |\n|---|\n| {sentence(20)} {sentence(21)} |\n")
        self.assertTrue(offender.startswith("text.md:3: a cell of 41 words"), offender)

    def test_code_and_comments_do_not_count(self):
        long = sentence(50)
        for text in (f"    {long}\n    {long}\n", f"```\n{long}\n```\n", f"<!-- {long}\n{long} -->\n", f"Run `{long}` now.\n", f"[Here]({'x' * 50} {long}).\n"):
            self.assertEqual(self.offenders(text), [], text)
        self.assertEqual(len(self.offenders(f"- item\n\n    {long}\n")), 2)  # no code: what an item goes on with

    def test_a_readme_has_so_many_lines_at_most(self):
        self.assertEqual(self.offenders("a.\n\n" * 60, "README.md"), [])
        (offender,) = self.offenders("a.\n\n" * 61, "README.md")
        self.assertIn("122 lines, at most 120", offender)

    def test_the_exit_code_says_whether_there_are_offenders(self):
        def run(*files):
            return subprocess.run(["/usr/bin/python3", str(SCRIPT), *map(str, files)], capture_output=True, text=True)

        with tempfile.TemporaryDirectory() as folder:
            good, bad = Path(folder, "good.md"), Path(folder, "bad.md")
            good.write_text(sentence(10))
            bad.write_text(f"{sentence(41)}\n\n{sentence(2)}\n")
            self.assertEqual(run(good).returncode, 0)
            found = run(good, bad)
            self.assertEqual((found.returncode, found.stdout.count("\n")), (1, 1))
            self.assertIn("bad.md:1:", found.stdout)
            self.assertEqual(run(Path(folder, "none.md")).returncode, 2)

    def test_our_own_texts_are_within_bounds(self):
        offenders = [offender for file in words.own_texts() for offender in words.offenders_in(words.name_of(file), file.read_text(encoding="utf-8"))]
        self.assertEqual(offenders, [])


def places_of(text):
    """What a link may name behind #: its headings as GitHub writes them."""
    headings = re.findall(r"^#+ (.*)$", text, flags=re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links_of(file):
    text = re.sub(r"^    .*$|`[^`\n]*`", "", words.without_comments(file.read_text(encoding="utf-8")), flags=re.MULTILINE)
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        path, _, place = link.partition("#")
        if re.match(r"[a-z]+://", path):
            continue
        target = file.parent / path if path else file
        if not target.exists():
            yield f"{file}: {link} is not there"
        elif place and place not in places_of(target.read_text(encoding="utf-8")):
            yield f"{file}: {link} has no such heading"


class Links(unittest.TestCase):
    def test_a_broken_link_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            text = Path(folder, "text.md")
            text.write_text("# Of `names` (all)\n\n[here](#of-names-all), [there](text.md), [nowhere](none.md), [no place](text.md#none)\n")
            self.assertEqual([problem.split(": ")[1] for problem in broken_links_of(text)], ["none.md is not there", "text.md#none has no such heading"])

    def test_every_link_leads_somewhere(self):
        self.assertEqual([problem for file in words.own_texts() for problem in broken_links_of(file)], [])


class Rows(unittest.TestCase):
    """A manual has a row for everything that registers itself."""

    def names(self, folder, what):
        found = set()
        for file in sorted((ROOT / folder).rglob("*.cpp")):
            found |= set(re.findall(rf"{what} registered\(.*?\.name = \"([^\"]+)\"", file.read_text(encoding="utf-8"), flags=re.DOTALL))
        return found

    def rows(self, text):
        """What stands in the first column."""
        cells = re.findall(r"^\| ([^|]*) \|", (ROOT / text).read_text(encoding="utf-8"), flags=re.MULTILINE)
        return {name.strip(" `") for cell in cells for name in cell.split(",")}

    def test_of_each_command(self):
        commands = self.names("bench", "RegisteredCommand")
        self.assertIn("render", commands)
        self.assertEqual(commands - self.rows("bench/README.md"), set())

    def test_of_each_engine(self):
        engines = self.names("bench/contenders/engines", "RegisteredEngine")
        self.assertIn("compact", engines)
        self.assertEqual(engines - self.rows("photonmap/README.md"), set())

    def test_of_each_basis(self):
        bases = {file.stem for file in (ROOT / "bench/contenders/bases").glob("*.cpp")}
        self.assertIn("F1", bases)
        self.assertEqual(bases - self.rows("shlm/README.md"), set())

    def test_of_each_report(self):
        self.assertEqual(set(REPORTS) - self.rows("bench/report/README.md"), set())


if __name__ == "__main__":
    unittest.main()
