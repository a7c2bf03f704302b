"""The results page without a browser: its rows, points, targets, words, and that it holds together. page_browser_test.py opens it."""

import contextlib
import io
import json
import math
import re
import shutil
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

import numpy as np
import page_results
from page_results import FEWER, HOSTILE, METHODS, NEAREST, RADIUS, SCENES, SHLM, SIZES, SMALL
from report.page import answer, chooser, history, page, pictures, stability
from report.page.find import find
from report.page.quantities import COSTS, ERRORS
from report.page.rows import StudyRows
from report.page.theory import fronts
from report.text import seconds_text

LONGEST_SENTENCE = 40  # words


class Reader(HTMLParser):
    """What elements there are, with their text."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.elements, self.texts, self._at = [], {}, -1
        self.feed(text)

    def handle_starttag(self, name, attributes):
        self.elements.append((name, dict(attributes)))
        self._at = len(self.elements) - 1

    def handle_data(self, text):
        self.texts[self._at] = self.texts.get(self._at, "") + text

    def all(self, name):
        return [attributes for found, attributes in self.elements if found == name]

    def text_of(self, identity):
        return next(self.texts.get(i, "") for i, (_, a) in enumerate(self.elements) if a.get("id") == identity)


def run(*arguments):
    """(exit code, stdout, stderr)"""
    out, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
        code = page.main([str(a) for a in arguments])
    return code, out.getvalue(), errors.getvalue()


class WithResults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.root = page_results.write_results(Path(cls.temporary.name) / "results")
        cls.out = cls.root / "index.html"
        cls.done = run(cls.out, cls.root)
        cls.results = find(cls.out, [cls.root])
        cls.study = StudyRows(cls.results.study)
        cls.text = cls.out.read_text(encoding="utf-8")
        cls.reader = Reader(cls.text)
        cls.data = json.loads(cls.reader.text_of("data"))

    def row(self, scene, method, hits):
        return next(r for r in self.study.rows if (r.scene, r.method, r.hits_asked) == (scene, method, hits))


class Rows(WithResults):
    def test_each_run_of_the_study_is_a_row(self):
        wanted = {(s, m, h) for s in SCENES for m in METHODS for h in SIZES}
        self.assertEqual({(r.scene, r.method, r.hits_asked) for r in self.study.rows}, wanted)
        self.assertEqual(len(self.study.rows), len(wanted))
        self.assertEqual([r.number for r in self.study.rows], list(range(len(wanted))))

    def test_errors_are_relative_rms_in_per_cent(self):
        summary = json.loads((self.root / "study" / "summary.json").read_text())
        for row in self.study.rows:
            point = next(p for p in summary["scenes"][row.scene]["methods"][row.method] if p["hits_asked"] == row.hits_asked)
            self.assertAlmostEqual(row.error, 100 * math.sqrt(point["error"]), places=9)
            self.assertAlmostEqual(row.noise, 100 * math.sqrt(point["variance"]), places=9)
            self.assertAlmostEqual(row.bias, 100 * math.sqrt(max(0, point["bias_sq"])), places=9)
            self.assertAlmostEqual(row.error_band[1], 100 * math.sqrt(point["error_band"][1]), places=9)

    def test_errors_are_those_of_the_law(self):
        """900 values a seed: the mean square is sure to 20 %."""
        law = METHODS[RADIUS]
        for hits in SIZES:
            wanted = law.variance(hits) + law.bias_sq(hits)
            self.assertAlmostEqual(self.row("cornell", RADIUS, hits).error ** 2 / 1e4 / wanted, 1, delta=0.2)

    def test_bytes_and_seconds(self):
        row = self.row("cornell", NEAREST, 100_000)
        self.assertEqual((row.bytes, row.working), (73e5, 146e5))
        self.assertAlmostEqual(row.seconds, 0.11, delta=0.01)

    def test_the_script_has_the_same_rows(self):
        charts = self.data["charts"]
        for values, row in zip(charts["rows"], self.study.rows, strict=True):
            found = dict(zip(charts["columns"], values))
            self.assertEqual((found["scene"], charts["methods"][found["method"]]["name"]), (row.scene, row.method))
            for name in ("error", "bias", "noise", "flip", "seconds", "bytes", "working", "hits"):
                self.assertAlmostEqual(found[name], getattr(row, name), delta=1e-5 * getattr(row, name))


class Charts(WithResults):
    def places(self):
        """number of the row -> (x, y) of its marker."""
        found = re.findall(r'<g id="p(\d+)" class="point".*?<use href="[^"]*" x="([^"]*)" y="([^"]*)"', self.text)
        return {int(number): (float(x), float(y)) for number, x, y in found}

    def axis(self, key):
        """[(label, x or y)] of the ticks"""
        group = re.search(rf'<g id="axis-{key}".*?</g>', self.text).group()
        return re.findall(r'<text x="([^"]*)" y="([^"]*)" text-anchor="[a-z]*">([^<]*)</text>', group)

    def test_points_are_rows(self):
        self.assertEqual(sorted(self.places()), [r.number for r in self.study.rows])

    def test_points_lie_where_the_axes_say(self):
        """Against the words on the axes alone: 100 ms and 1 s, 2 % and 20 %."""
        along = {label.replace("\u00a0", " "): float(x) for x, _, label in self.axis("seconds")}
        up = {label.replace("\u00a0", " "): y for y, label in self.grid_of("error")}
        for number, (x, y) in self.places().items():
            row = self.study.rows[number]
            wanted_x = along["100 ms"] + (along["1 s"] - along["100 ms"]) * math.log10(row.seconds / 0.1)
            wanted_y = up["2 %"] + (up["20 %"] - up["2 %"]) * math.log10(row.error / 2)
            self.assertAlmostEqual(x, wanted_x, delta=0.1)
            self.assertAlmostEqual(y, wanted_y, delta=0.1)

    def grid_of(self, key):
        """The lines of a vertical axis with their words, bottom first."""
        group = re.search(rf'<g id="axis-{key}".*?</g>', self.text).group()
        lines = [float(y) for y in re.findall(r'<path d="M [\d.]+ ([\d.]+) L', group)]
        words = [label for _, _, label in self.axis(key)]
        return list(zip(lines, words))

    def test_nobody_beats_the_front(self):
        for cost in COSTS:
            for error in ERRORS:
                for scene in SCENES:
                    rows = [r for r in self.study.rows if r.scene == scene and error.of(r)]  # a bias that is lost in the noise is none
                    better = lambda a, b: cost.of(a) <= cost.of(b) and error.of(a) < error.of(b) or cost.of(a) < cost.of(b) and error.of(a) <= error.of(b)
                    wanted = {r.number for r in rows if not any(better(other, r) for other in rows)}
                    found = fronts(self.study)[f"{cost.key}/{error.key}"][scene]
                    self.assertEqual(found, sorted(wanted, key=lambda n: cost.of(self.study.rows[n])))

    def test_what_is_not_of_the_best_is_grey(self):
        names = [m["name"] for m in self.data["charts"]["methods"]]
        found = re.findall(r'<g class="(series[ a-z]*)" data-method="(\d+)"', self.text)
        self.assertEqual(len(found), len(METHODS) * len(SCENES))
        for words, method in found:
            self.assertEqual("dim" not in words, names[int(method)] in self.study.best_known)
        self.assertLess(len(self.study.best_known), len(METHODS))

    def test_shapes_tell_methods_apart_without_colour(self):
        """Shape, size, filling and dash of no two methods are the same."""
        shapes = dict(re.findall(r'<path id="(\w+)" d="([^"]*)"', self.text))
        seen = {}
        for method, first, mark, style in re.findall(r'<g class="series[^"]*" data-method="(\d+)">.*?id="l(\d+)".*?<use href="#(\w+)"[^>]*style="([^"]*)"', self.text):
            dash = re.search(rf'style="([^"]*)" id="l{first}"', self.text).group(1)
            seen[method] = (shapes[mark], "fill: none" in style, *re.findall("dasharray: ([^;]*)", dash))
        self.assertEqual(len(seen), len(METHODS))
        self.assertEqual(len(set(seen.values())), len(METHODS))

    def test_theory_halves_the_slope_of_the_square(self):
        ghosts = {g["slope"]: g["line"] for g in self.data["charts"]["ghosts"]["cornell"]["hits"]}
        self.assertEqual(sorted(ghosts), [-1 / 2, -1 / 3, 0])
        for slope, ((first, above), (last, below)) in ghosts.items():
            self.assertAlmostEqual(math.log(above / below) / math.log(last / first), -slope)
        self.assertAlmostEqual(ghosts[0][1][1] / self.row("cornell", NEAREST, SIZES[-1]).noise, 1, delta=1e-5)


def offer_by_hand(rows, scene, family, target, cost):
    """(reached, number of the first run within the target, cost there) of the cheapest method; of the most accurate run where there is none."""
    rows = [r for r in rows if r.scene == scene and r.method.startswith(family)]
    found = []
    for method in {r.method for r in rows}:
        runs = sorted((r for r in rows if r.method == method), key=lambda r: r.hits_asked)
        at = next((i for i, r in enumerate(runs) if r.error <= target), None)
        if at is not None:
            after, before = runs[at], runs[max(at - 1, 0)]
            line = np.log([(after.error, getattr(after, cost)), (before.error, getattr(before, cost))]).T
            found.append((math.exp(np.interp(math.log(target), *line)), after.number))
    if found:
        return True, min(found)[1], min(found)[0]
    best = min(rows, key=lambda r: r.error)
    return False, best.number, getattr(best, cost)


class Choosing(WithResults):
    def test_the_cheapest_of_each_family(self):
        reached = set()
        for scene in SCENES:
            for cost in ("seconds", "bytes"):
                for target in (30, 10, 5, 2, 0.5):
                    found = chooser.offers(self.study, scene, target, cost)
                    self.assertEqual({o.family for o in found}, {"shlm", "photonmap"})
                    for offer in found:
                        wanted = offer_by_hand(self.study.rows, scene, offer.family, target, cost)
                        self.assertEqual((offer.reached, offer.row.number), wanted[:2])
                        self.assertAlmostEqual(getattr(offer, cost) / wanted[2], 1, delta=1e-9)
                        reached.add((offer.reached, offer.before is None))
        self.assertEqual(reached, {(True, False), (True, True), (False, True)})

    def test_it_reads_between_sizes_as_the_study_does(self):
        for scene in SCENES:
            entry = self.study.source.document["scenes"][scene]
            for key in ("seconds", "bytes"):
                for target, reached in entry[f"{key}_to_reach"].items():
                    costs = {m: r["cost"] for m, r in reached.items() if r["cost"] is not None}
                    for offer in chooser.offers(self.study, scene, 100 * float(target), key):
                        of_family = [c for m, c in costs.items() if m.startswith(offer.family)]
                        self.assertEqual(offer.reached, bool(of_family))
                        if of_family:
                            self.assertAlmostEqual(getattr(offer, key) / min(of_family), 1, delta=1e-9)

    def test_the_first_one_is_the_cheapest(self):
        first, second = chooser.offers(self.study, "cornell", 30, "seconds")
        self.assertLessEqual(first.seconds, second.seconds)

    def test_what_is_out_of_reach_says_how_near_it_came(self):
        offers = chooser.offers(self.study, "cornell", 0.5, "seconds")
        cells = chooser.offer_cells(self.study, "cornell", offers, offers[0], "seconds")
        self.assertIn("not reached up to 1\u00a0M hits: best is", cells[2])
        self.assertNotIn("render", cells[-1])

    def offer_of(self, method, hits):
        """Of a target that one run reaches."""
        return chooser.reach("", [self.row("bumpy", method, hits)], target=1e9)

    def test_commands_name_method_hits_and_texels(self):
        self.assertEqual(
            chooser.command(self.study, self.offer_of(RADIUS, 100_000)),
            f"build/release/shlmbench render build/release/scenes/bumpy.glb --method {RADIUS} --hits 1e5 --out picture.exr",
        )
        self.assertIn("--texels 100 ", chooser.command(self.study, self.offer_of(SHLM, 100_000)))
        self.assertNotIn("--texels", chooser.command(self.study, self.offer_of(SMALL, 100_000)))

    def test_hits_as_a_word(self):
        hits = (10_000, 10**8, 3 * 10**5, 123_456, 10**10, 2_400_000.1, 9_999_999.5, 999)
        self.assertEqual([chooser.hits_word(h) for h in hits], ["1e4", "1e8", "3e5", "1.3e5", "1e10", "2.5e6", "1e7", "1e3"])


class Words(WithResults):
    def test_five_lines_are_printed(self):
        code, out, errors = self.done
        self.assertEqual((code, errors), (0, ""))
        lines = out.splitlines()
        self.assertEqual(lines[:5], answer.lines(self.results, self.study))
        self.assertEqual(lines[5:], ["", str(self.out)])
        self.assertEqual(lines[0], "Of the paper's 4 claims 1 holds, 1 holds under a condition, 1 fails and 1 is not decided yet.")

    def test_who_is_first_is_who_is_cheapest(self):
        line, costs = answer.first_line(self.study), answer.cost_line(self.study)
        for scene in SCENES:
            reached = self.study.source.document["scenes"][scene]["seconds_to_reach"]["0.05"]
            first = min((m for m in reached if reached[m]["cost"] is not None), key=lambda m: reached[m]["cost"])
            who = "light map" if first.startswith("shlm") else "photon map"
            self.assertRegex(line, rf"{who} in [^;]*{scene}")
            self.assertIn(seconds_text(reached[first]["cost"]), costs)

    def test_sentences_are_short(self):
        for line in answer.lines(self.results, self.study):
            for sentence in re.split(r"(?<=[.;:])\s", line):
                self.assertLessEqual(len(sentence.split()), LONGEST_SENTENCE, sentence)

    def test_conditions_are_the_verdicts_own(self):
        for row in page_results.verdicts():
            said = re.search(rf'<tr id="claim-{row["claim"]}">.*?</tr>', self.text, re.DOTALL).group()
            self.assertIn(row["condition"], said)

    def test_each_panel_names_its_own_commit(self):
        for identity in (f"chart-{scene}" for scene in SCENES):
            figure = re.search(rf'<figure class="chart" id="{identity}">.*?</figure>', self.text, re.DOTALL).group()
            self.assertIn("0123456789ab", figure)
            self.assertIn("3 seeds", figure)
        cases = self.text[self.text.index('<section id="stability">') : self.text.index('<section id="elsewhere">')]
        self.assertIn("bbbbbbbbbbbb", cases)
        self.assertNotIn("0123456789ab", cases)


    def test_fragment_programs_have_their_errors_and_viewers(self):
        part = self.text[self.text.index('<section id="lit">') : self.text.index('<section id="stability">')]
        self.assertIn("bumpy 10.2 % beside 35.7 %; cornell 5.1 % beside 5.1 %", part)
        self.assertIn('<a href="realtime/viewer-bumpy.html">bumpy</a>', part)

    def test_scenes_of_others_are_counted(self):
        part = self.text[self.text.index('<section id="elsewhere">') : self.text.index('<section id="fits">')]
        self.assertIn("Of 2 scenes that others made, within all bounds: 1; outside one: 0; left open by chance or not measured: 1.", part)
        self.assertIn("+0.40 ± 0.10", part)
        self.assertIn("dddddddddddd", part)


class Whole(WithResults):
    def test_no_text_becomes_markup(self):
        self.assertEqual(len(self.reader.all("script")), 3)
        self.assertNotIn("<script>alert", self.text)
        self.assertIn("&lt;script&gt;alert", self.text)
        spoken = page.script_json({"x": HOSTILE})
        self.assertNotIn("<", spoken)
        self.assertEqual(json.loads(spoken), {"x": HOSTILE})

    def test_nothing_is_fetched_and_every_link_is_there(self):
        ids = {a["id"] for _, a in self.reader.elements if a.get("id")}
        for name, attributes in self.reader.elements:
            for key in ("src", "href"):
                target = attributes.get(key)
                if target is None or target == "data:,":
                    continue
                self.assertNotRegex(target, r"^(\w+:|/)")
                if target.startswith("#"):
                    self.assertIn(target[1:], ids, name)
                else:
                    self.assertTrue((self.root / target).exists(), target)
        self.assertEqual({a.get("src") for a in self.reader.all("script")}, {None})
        self.assertEqual(self.reader.all("iframe") + self.reader.all("object"), [])

    def test_ids_are_there_once(self):
        ids = [a["id"] for _, a in self.reader.elements if a.get("id")]
        self.assertEqual(sorted(ids), sorted(set(ids)))

    def test_all_sections(self):
        found = [a["id"] for a in self.reader.all("section")]
        self.assertEqual(found, ["claims", "choose", "charts", "pictures", "lit", "stability", "elsewhere", "fits", "history", "measured", "words"])

    def test_charts_have_a_sentence(self):
        sentences = re.findall(r'<p class="finding">([^<]+)</p>', self.text)
        self.assertGreaterEqual(len(sentences), len(SCENES) + 3)  # the charts, stability, fits, history


def luminance(colour):
    """Relative, of #rgb or #rrggbb, as WCAG has it."""
    digits = colour[1:] if len(colour) == 7 else "".join(2 * c for c in colour[1:])
    parts = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


class Style(unittest.TestCase):
    LEAST = 4.5

    def test_words_stand_out_by_day_by_night_and_on_paper(self):
        style = (Path(page.__file__).parent / "page.css").read_text()
        roots = [dict(re.findall(r"--(\w+): (#\w+);", block)) for block in re.findall(r":root \{([^}]*)\}", style)]
        self.assertEqual(len(roots), 3)
        for root in roots:
            scheme = roots[0] | root
            for name in ("ink", "soft", "accent", "holds", "if", "fails", "open"):
                for ground in ("ground", "tint"):
                    self.assertGreaterEqual(contrast(scheme[name], scheme[ground]), self.LEAST, (name, ground, scheme[ground]))

    def test_coloured_cells_too(self):
        style = (Path(page.__file__).parent / "page.css").read_text()
        found = re.findall(r"td\.\w+ \{ color: (#\w+); font-weight: 700; background: (#\w+);", style)
        self.assertEqual(len(found), 2)
        for colour, ground in found:
            self.assertGreaterEqual(contrast(colour, ground), self.LEAST)


class Stability(unittest.TestCase):
    def test_states(self):
        found = {row["name"]: stability.state(row) for row in page_results.stability()["rows"]}
        self.assertEqual(found, {"calm": "fine", "close": "near", "broken": "failing", "shown": "fine"})

    def test_at_most_counts_only_what_is_above(self):
        curve = {"expected": "at most"}
        self.assertEqual(stability.used(curve, page_results.point(0, 1, 0.2)), 0)
        self.assertAlmostEqual(stability.used(curve, page_results.point(0, 1, 1.05)), 0.5)


class History(unittest.TestCase):
    def test_only_what_leaves_its_band_is_coloured_and_what_was_not_run_is_a_gap(self):
        lines = history.comparisons(page_results.history())
        self.assertEqual([len(lines), history.finding(lines)],
                         [2, "In 2 comparisons 1 time left the noise band as slower and 1 as faster; 0 errors became worse and 1 better."])
        table = history.ratios_table(lines, "benchmarks")
        self.assertEqual(re.findall(r'<td class="(\w+)"', table), ["up", "same", "same", "down"])
        errors = history.ratios_table(lines, "errors")
        self.assertEqual(re.findall(r'<td class="(\w+)"', errors), ["down", "gap"])


class Pictures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)
        page_results.add_study(self.root / "study")

    def sets(self):
        results = find(self.root / "index.html", [self.root])
        study = StudyRows(results.study)
        pictures.keep(study)
        return results, study, pictures.sets_of(results, study)

    def test_kept_without_the_raw_answers(self):
        results, study, before = self.sets()
        self.assertEqual({s.scene for s in before}, set(SCENES))
        shutil.rmtree(self.root / "study" / "raw")
        _, _, after = self.sets()
        self.assertEqual(after, before)
        for one in after:
            for file in [item.file for item in one.items] + list(one.flips.values()):
                self.assertTrue((self.root / file).exists(), file)

    def test_the_most_accurate_within_the_budget(self):
        results, study, sets = self.sets()
        budget = next(r for r in study.rows if (r.scene, r.method, r.hits_asked) == ("cornell", NEAREST, 1_000_000))
        found = []
        for kind, cost in (("time", "seconds"), ("bytes", "bytes")):
            limit = 1.1 * getattr(budget, cost)
            rows = [r for r in study.rows if r.scene == "cornell" and r.method.startswith("shlm") and getattr(r, cost) <= limit]
            found.append(min(rows, key=lambda r: r.error).method)
            words = next(s for s in sets if s.scene == "cornell" and f"same {kind}" in s.title).items[1].words
            self.assertTrue(words.startswith(f"{found[-1]}, "), words)
        self.assertEqual((found[0], found[1] == found[0]), (FEWER, False))  # the large one is fast enough, and too large

    def test_pictures_of_another_commit_are_not_shown(self):
        self.sets()
        shutil.rmtree(self.root / "study" / "raw")
        file = self.root / "study" / "summary.json"
        document = json.loads(file.read_text())
        document["context"]["commit"] = "another"
        file.write_text(json.dumps(document))
        self.assertEqual(self.sets()[2], [])


class Parts(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)
        self.out = self.root / "index.html"

    def test_a_part_alone_makes_a_page_that_says_what_is_missing(self):
        page_results.write(self.root / "stability" / "stability.json", page_results.stability())
        code, out, errors = run(self.out, self.root / "stability")
        self.assertEqual((code, errors), (0, ""))
        text = self.out.read_text()
        for command in ("bench/report verdicts", "./reproduce --full", "./reproduce --models", "bench/track BASE"):
            self.assertIn(command, text)
        self.assertIn("broken", text)

    def test_own_runs_beside_the_kept_results_are_left_out(self):
        for name in ("stability", "latest"):
            page_results.write(self.root / name / "stability.json", page_results.stability())
        self.assertEqual([source.name for source in find(self.out, [self.root]).stability], ["stability"])
        self.assertEqual([source.name for source in find(self.out, [self.root / "latest"]).stability], ["latest"])

    def test_studies_are_not_joined(self):
        page_results.add_study(self.root / "study")
        shutil.copytree(self.root / "study", self.root / "older")
        file = self.root / "older" / "summary.json"
        document = json.loads(file.read_text())
        del document["scenes"]["bumpy"]
        file.write_text(json.dumps(document))
        self.assertEqual(run(self.out, self.root)[0], 0)
        text = self.out.read_text()
        self.assertEqual(text.count('class="point"'), len(METHODS) * len(SIZES) * len(SCENES))
        self.assertIn("Other studies here are not joined to it: older.", text)

    def test_bad_input_is_one_line_and_leaves_the_old_page(self):
        self.out.write_text("the old page")
        (self.root / "broken").mkdir()
        (self.root / "broken" / "summary.json").write_text("{")
        page_results.write(self.root / "other" / "compare.json", {"rows": []})
        page_results.write(self.root / "odd" / "summary.json", {"scenes": {"s": {"methods": {"m": [{}]}}}, "context": {}})
        (self.root / "empty").mkdir()
        wanted = {"broken": "summary.json", "other": "compare.json", "odd": "without", "empty": "no results", "nowhere": "no folder"}
        for name, words in wanted.items():
            code, out, errors = run(self.out, self.root / name)
            self.assertEqual((code, out, errors.count("\n")), (2, "", 1), name)
            self.assertIn(words, errors)
            self.assertEqual(self.out.read_text(), "the old page")
        self.assertEqual([f.name for f in self.root.glob("*.part")], [])


if __name__ == "__main__":
    unittest.main()
