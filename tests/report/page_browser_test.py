"""The results page in a headless Chromium: what is drawn, what keys and filters do, what it asks for, what is left without script. Skipped where there is none."""

import json
import math
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

import page_results
from page_results import FEWER, NEAREST, SCENES, SIZES
from page_test import offer_by_hand, run
from report.browser import Browser, find_browser
from report.page.chooser import hits_word, offers
from report.page.facets import facts_of
from report.page.find import find
from report.page.rows import StudyRows

SECTIONS = ("claims", "choose", "charts", "pictures", "lit", "stability", "elsewhere", "fits", "history", "measured", "words")
COSTS, ERRORS = ("seconds", "bytes", "working", "hits"), ("error", "bias", "noise", "flip")
UNITS = {"": 1, "%": 1, "ms": 1e-3, "s": 1, "k": 1e3, "M": 1e6, "G": 1e9, "B": 1, "KiB": 2**10, "MiB": 2**20, "GiB": 2**30}
NARROW = 400

# Where the markers of a chart lie, and where its axes put their lines and words: all in pixels of the window.
PLACES = """(() => {
  const panel = document.querySelector('.panel[data-scene="%s"]'), box = panel.getBoundingClientRect(), scale = box.width / panel.viewBox.baseVal.width;
  const axis = which => {
    const group = document.querySelector(panel.querySelector(which).getAttribute('href'));
    const lines = [...group.querySelectorAll('path')].map(p => p.getAttribute('d').match(/-?[\\d.]+/g).map(Number));
    const words = [...group.querySelectorAll('text')].map(t => t.textContent);
    return lines.map((d, i) => [words[i], which === '.x-axis' ? box.left + scale * d[0] : box.top + scale * d[1]]);
  };
  const middle = e => { const b = e.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; };
  const points = Object.fromEntries([...panel.querySelectorAll('.point')].map(p => [p.id.slice(1), [...middle(p), p.getBoundingClientRect().width]]));
  return { x: axis('.x-axis'), y: axis('.y-axis'), points };
})()"""


def value_of(label):
    number, unit = re.fullmatch(r"([\d.e-]+)\s?(.*)", label.replace("\u00a0", " ")).groups()
    return float(number) * UNITS[unit]


def expected(ticks, value):
    """Where a value lies by the outermost two lines of a logarithmic axis."""
    (low, at_low), (high, at_high) = sorted((value_of(label), place) for label, place in ticks)[:: len(ticks) - 1]
    return at_low + (at_high - at_low) * math.log(value / low) / math.log(high / low)


@unittest.skipUnless(find_browser(), "no Chromium is installed: the page is not opened (.ci/prepare installs chromium-headless-shell)")
class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.root = page_results.write_results(Path(temporary.name) / "results")
        cls.out = cls.root / "index.html"
        assert run(cls.out, cls.root)[0] == 0
        cls.study = StudyRows(find(cls.out, [cls.root]).study)
        cls.browser = Browser(find_browser())
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.scripts(True)
        self.browser.media("")

    def open(self, state="", **size):
        self.browser.open(self.out.as_uri() + (f"#{state}" if state else ""), **size)

    def ask(self, expression):
        return self.browser.evaluate(expression)

    def rows_of(self, scene):
        return [r for r in self.study.rows if r.scene == scene]

    def bright(self, scene):
        """Numbers of the rows that are drawn and not grey."""
        return set(self.ask(f"""[...document.querySelectorAll('.panel[data-scene="{scene}"] .series:not(.dim) .point:not(.absent)')].map(p => +p.id.slice(1))"""))

    # --- what is drawn

    def test_points_are_rows(self):
        self.open("show=all")
        for scene in SCENES:
            rows = {r.number for r in self.rows_of(scene)}
            self.assertEqual(self.bright(scene), rows)
            places = self.ask(PLACES % scene)["points"]
            self.assertEqual({int(n) for n, (_, _, width) in places.items() if width > 0}, rows)
        self.assertEqual(self.ask("document.querySelectorAll('#rows tbody tr').length"), len(self.study.rows))

    def test_a_known_point_lies_where_its_numbers_say(self):
        """To a pixel, on all sixteen pairs of axes."""
        row = next(r for r in self.rows_of("bumpy") if r.method == NEAREST and r.hits_asked == 100_000)
        for x in COSTS:
            for y in ERRORS:
                self.open(f"x={x}&y={y}")
                found = self.ask(PLACES % "bumpy")
                left, top, _ = found["points"][str(row.number)]
                self.assertAlmostEqual(left, expected(found["x"], getattr(row, x)), delta=1, msg=f"{x}/{y}")
                self.assertAlmostEqual(top, expected(found["y"], getattr(row, y)), delta=1, msg=f"{x}/{y}")

    def test_the_front_passes_through_its_runs(self):
        self.open("x=hits&y=noise")
        data = json.loads(self.ask("document.getElementById('data').textContent"))["charts"]
        path = self.ask("""document.querySelector('.panel[data-scene="cornell"] .front').getAttribute('d')""")
        corners = {tuple(map(float, corner)) for corner in re.findall(r"([\d.]+) ([\d.]+)", path)}
        for number in data["fronts"]["hits/noise"]["cornell"]:
            x, y = self.ask(f"(use => [+use.getAttribute('x'), +use.getAttribute('y')])(document.querySelector('#p{number} use'))")
            self.assertIn((x, y), corners)

    # --- filters

    def test_filters_grey_what_they_should(self):
        self.open()
        self.assertEqual(self.bright("cornell"), {r.number for r in self.rows_of("cornell") if r.method in self.study.best_known})
        self.browser.click('.chip[data-facet="basis"][data-value="F1"]')
        passing = lambda method: facts_of(self.study.kinds[method]).get("basis", "F1") == "F1"
        wanted = {r.number for r in self.rows_of("cornell") if passing(r.method)}
        self.assertEqual(self.bright("cornell"), wanted)
        self.browser.click('.chip[data-facet="family"][data-value="light map"]')
        self.assertEqual(self.bright("cornell"), {r.number for r in self.rows_of("cornell") if r.method == FEWER})
        grey = self.ask("document.querySelectorAll('.panel .series.dim .point').length")
        self.assertEqual(grey, len(self.study.rows) - len(SIZES) * len(SCENES))  # still there
        legend = self.ask("[...document.querySelectorAll('.legend li:not([hidden])')].map(e => e.textContent.trim())")
        self.assertEqual(legend, [FEWER])

    def test_chips_count_their_runs(self):
        self.open()
        found = self.ask("[...document.querySelectorAll('.chip[data-facet]')].map(c => [c.dataset.facet, c.dataset.value, +c.querySelector('small').textContent])")
        self.assertGreater(len(found), 4)
        for facet, value, count in found:
            self.assertEqual(count, sum(facts_of(self.study.kinds[r.method]).get(facet) == value for r in self.study.rows), (facet, value))

    def test_csv_has_the_runs_that_are_not_grey(self):
        self.open("show=all&f.basis=F1&f.family=light+map")
        self.ask("(() => { window.blobs = []; URL.createObjectURL = blob => { blobs.push(blob); return '#'; }; })()")
        self.browser.click("#csv")
        head, *lines = self.ask("blobs[0].text()").strip().split("\n")
        method, error = head.split(",").index("method"), head.split(",").index("error")
        wanted = [r for r in self.study.rows if r.method == FEWER]
        self.assertEqual([line.split(",")[method] for line in lines], [FEWER] * len(wanted))
        for line, row in zip(lines, wanted):
            self.assertAlmostEqual(float(line.split(",")[error]) / row.error, 1, delta=1e-5)

    def test_the_table_sorts(self):
        self.open("show=all")
        numbers = "[...document.querySelectorAll('#rows tbody tr')].map(r => +r.id.slice(1))"
        for sign in (1, -1):
            self.browser.click("#rows th:nth-child(5) button")
            errors = [self.study.rows[n].error for n in self.ask(numbers)]
            self.assertEqual(errors, sorted(errors, key=lambda e: sign * e))
            self.assertEqual(self.ask("document.querySelector('#rows th:nth-child(5)').ariaSort"), "ascending" if sign > 0 else "descending")

    # --- targets

    def offered(self):
        """[(number of the row, reached)] in order."""
        return [tuple(o) for o in self.ask("[...document.querySelectorAll('#offers tbody tr')].map(r => [+r.dataset.row, r.dataset.reached === 'true'])")]

    def by_hand(self, scene, target, cost):
        found = [offer_by_hand(self.study.rows, scene, family, target, cost) for family in ("shlm", "photonmap")]
        found.sort(key=lambda f: (not f[0], f[2] if f[0] else self.study.rows[f[1]].error))
        return [(number, reached) for reached, number, _ in found]

    def test_the_chooser_gives_the_cheapest(self):
        for target in (30, 10, 5, 1):
            for cost in ("seconds", "bytes"):
                self.open(f"need={target}&by={cost}&scene=bumpy")
                self.assertEqual(self.offered(), self.by_hand("bumpy", target, cost), (target, cost))

    def test_the_chooser_listens(self):
        self.open()
        self.ask("document.getElementById('target').focus(), document.getElementById('target').select()")
        self.browser.call("Input.insertText", text="9")
        self.ask("(s => { s.value = 'cornell'; s.dispatchEvent(new Event('change')); })(document.getElementById('target-scene'))")
        self.assertEqual(self.offered(), self.by_hand("cornell", 9, "seconds"))
        self.assertIn("need=9", self.ask("location.hash"))
        command = self.ask("document.querySelector('#offers .command').textContent")
        offer = offers(self.study, "cornell", 9, "seconds")[0]
        self.assertIn(f"scenes/cornell.glb --method {offer.row.method} --hits {hits_word(offer.hits)} ", command)

    def test_the_script_says_what_the_page_says_without_it(self):
        cells = "[...document.querySelectorAll('#offers tbody tr')].map(r => [...r.cells].map(c => c.textContent.replace('copy', '').trim()))"
        self.open()
        with_script = self.ask(cells)
        self.assertIn("%", "".join(cell for row in with_script for cell in row[6]))
        self.browser.scripts(False)
        self.open()
        self.assertEqual(self.ask(cells), with_script)
        self.assertEqual(len(with_script), 2 * len(SCENES))

    # --- keys and pointer

    def focused(self):
        return self.ask("document.activeElement.id")

    def test_keys_reach_every_point(self):
        self.open("show=all")
        for _ in range(300):  # by Tab from the top of the page
            self.browser.press("Tab")
            if self.ask("document.activeElement.matches('.point')"):
                break
        wanted = {f"p{r.number}" for r in self.rows_of("cornell")}
        for key, value, sign in (("ArrowRight", "seconds", 1), ("ArrowLeft", "seconds", -1), ("ArrowUp", "error", 1), ("ArrowDown", "error", -1)):
            reached = []
            for _ in wanted:
                reached.append(self.focused())
                self.browser.press(key)
            self.assertEqual(set(reached), wanted, key)
            values = [sign * getattr(self.study.rows[int(p[1:])], value) for p in reached]
            first = values.index(min(values))
            self.assertEqual(values[first:] + values[:first], sorted(values), key)  # round and round
        self.assertIn(self.study.rows[int(self.focused()[1:])].method, self.ask("document.getElementById('tip').textContent"))

    def test_grey_points_are_passed_over(self):
        self.open("show=all&f.basis=F1&f.family=light+map")
        self.ask("""document.querySelector('.panel[data-scene="cornell"] .point[tabindex="0"]').focus()""")
        reached = set()
        for _ in self.study.rows:
            reached.add(self.focused())
            self.browser.press("ArrowRight")
        self.assertEqual(reached, {f"p{r.number}" for r in self.rows_of("cornell") if r.method == FEWER})

    def test_hovering_says_what_a_point_is(self):
        self.open("show=all")
        row = next(r for r in self.rows_of("cornell") if r.method == FEWER)
        self.ask(f"document.getElementById('p{row.number}').scrollIntoView({{block: 'center'}})")
        x, y, _ = self.ask(PLACES % "cornell")["points"][str(row.number)]
        self.browser.move(x, y)
        self.assertFalse(self.ask("document.getElementById('tip').hidden"))
        said = self.ask("document.getElementById('tip').innerText")
        self.assertIn(FEWER, said)
        self.assertIn(f"error: {row.error:.3g}", said)
        self.browser.move(1, 1)
        self.assertTrue(self.ask("document.getElementById('tip').hidden"))

    def test_two_pins_say_what_differs(self):
        self.open("show=all")
        self.ask("""document.querySelector('.panel[data-scene="cornell"] .point[tabindex="0"]').focus()""")
        pins = []
        for _ in range(2):
            pins.append(int(self.focused()[1:]))
            self.browser.press("Enter")
            self.browser.press("ArrowUp")
        self.assertIn(f"pin={pins[0]}%2C{pins[1]}", self.ask("location.hash"))
        rows = [self.study.rows[n] for n in pins]
        heads, first, second = self.ask("[...document.querySelectorAll('#pins tr')].map(r => [...r.cells].map(c => [c.className, c.textContent]))")
        found = {name: (kind, [one, other]) for (_, name), (kind, one), (_, other) in zip(heads, first, second)}
        self.assertEqual(found["method"][1], [r.method for r in rows])
        self.assertEqual(found["scene"], ("", ["cornell", "cornell"]))
        self.assertEqual(found["error"][0], "differs")
        self.assertEqual(self.ask("document.querySelectorAll('.point.pinned').length"), 2)
        self.browser.press("Escape")
        self.assertEqual(self.ask("document.querySelectorAll('.point.pinned').length"), 0)

    def test_the_address_brings_everything_back(self):
        self.open()
        self.browser.click("#all")
        self.browser.click('.chip[data-facet="kernel"]')
        self.ask("(s => { s.value = 'bytes'; s.dispatchEvent(new Event('change')); })(document.getElementById('x'))")
        places = "[...document.querySelectorAll('.point use')].map(u => [u.parentNode.id, u.getAttribute('x'), u.getAttribute('y')]).sort()"
        before, address = (self.bright("bumpy"), self.ask(places)), self.ask("location.hash")
        self.open(address[1:])
        self.assertEqual((self.bright("bumpy"), self.ask(places)), before)
        self.assertEqual(self.ask("document.getElementById('x').value"), "bytes")

    # --- pictures, cases

    def clip(self):
        return self.ask("getComputedStyle(document.querySelectorAll('.frame img')[1]).clipPath")

    def test_pictures_slide_flip_and_zoom(self):
        self.open()
        self.assertRegex(self.clip(), "50%")
        self.ask("(s => { s.value = 20; s.dispatchEvent(new Event('input')); })(document.querySelector('#viewer input[type=range]'))")
        self.assertRegex(self.clip(), "80%")
        self.ask("document.querySelector('.stage').focus()")
        self.browser.hold("f", True)
        self.assertNotIn("%", self.clip())
        self.browser.hold("f", False)
        self.assertRegex(self.clip(), "80%")
        width = "document.querySelector('.frame img').getBoundingClientRect().width"
        before = self.ask(width)
        self.ask("(s => { s.value = '4'; s.dispatchEvent(new Event('change')); })(document.getElementById('picture-zoom'))")
        self.assertAlmostEqual(self.ask(width) / before, 4, delta=0.01)
        self.ask("(s => { s.value = 'difference'; s.dispatchEvent(new Event('change')); })(document.getElementById('picture-view'))")
        self.assertEqual(self.ask("getComputedStyle(document.querySelectorAll('.frame img')[1]).mixBlendMode"), "difference")

    def test_pictures_are_there(self):
        self.open()
        for number in range(2 * len(SCENES)):
            self.open(f"set={number}")
            loaded = self.ask("Promise.all([...document.querySelectorAll('.frame img')].map(i => i.decode().then(() => i.naturalWidth)))")
            self.assertEqual(len(loaded), 2)
            self.assertTrue(all(width > 0 for width in loaded))

    def test_cases_can_be_narrowed(self):
        self.open()
        self.browser.click('[data-show="failing"]')
        self.assertEqual(self.ask("[...document.querySelectorAll('.case')].filter(c => c.offsetHeight).map(c => c.querySelector('b').textContent)"), ["broken"])

    # --- what holds it together

    def test_nothing_leaves_the_page(self):
        self.open("show=all")
        self.ask("document.querySelectorAll('img').forEach(i => { i.loading = 'eager'; })")
        for identity in SECTIONS:
            self.ask(f"document.getElementById('{identity}').scrollIntoView()")
        self.ask("Promise.all([...document.images].map(i => i.decode().catch(() => 0)))")
        self.assertGreater(len(self.browser.requests), len(SCENES))
        for address in self.browser.requests:
            self.assertTrue(address.startswith((self.root.as_uri(), "data:,")), address)
        self.assertEqual(self.browser.complaints, [])

    def test_the_narrow_page_does_not_scroll_sideways(self):
        self.open(width=NARROW)
        self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), NARROW)

    def test_it_prints_all_sections(self):
        self.open("cases=failing")
        self.browser.media("print")
        heights = self.ask("Object.fromEntries([...document.querySelectorAll('section')].map(s => [s.id, s.offsetHeight]))")
        self.assertEqual(tuple(heights), SECTIONS)
        self.assertTrue(all(height > 40 for height in heights.values()), heights)
        self.assertEqual(self.ask("[...document.querySelectorAll('.controls, .filters, nav')].filter(e => e.offsetHeight).length"), 0)
        self.assertEqual(self.ask("[...document.querySelectorAll('.case, .pictures, .panel')].filter(e => !e.getBoundingClientRect().height).length"), 0)
        paper = self.browser.pdf()
        self.assertTrue(paper.startswith(b"%PDF"))
        self.assertGreater(len(re.findall(rb"/Type\s*/Page\b", paper)), 3)

    def test_without_script(self):
        self.browser.scripts(False)
        self.open()
        visible = lambda selector: self.ask(f"[...document.querySelectorAll({json.dumps(selector)})].filter(e => e.getBoundingClientRect().height > 0).length")
        self.assertEqual(visible("table.claims tbody tr"), 4)
        self.assertEqual(visible("#offers tbody tr"), 2 * len(SCENES))
        self.assertEqual(visible(".panel[data-scene] .point"), len(self.study.rows))
        self.assertEqual(visible("#rows tbody tr"), len(self.study.rows))
        self.assertEqual(visible(".script-only"), 0)
        self.assertEqual(visible(".legend li"), len(self.study.best_known))
        self.assertGreater(visible(".strip img"), 2 * len(SCENES))
        row = next(r for r in self.rows_of("cornell") if r.method == NEAREST)
        found = self.ask(PLACES % "cornell")
        left, top, _ = found["points"][str(row.number)]
        self.assertAlmostEqual(left, expected(found["x"], row.seconds), delta=1)
        self.assertAlmostEqual(top, expected(found["y"], row.error), delta=1)


if __name__ == "__main__":
    if not find_browser():
        print("no Chromium is installed: the results page is not opened (.ci/prepare installs chromium-headless-shell)")
    unittest.main()
