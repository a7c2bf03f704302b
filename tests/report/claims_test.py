"""The verdicts on the paper's claims, on tables made up for the purpose: claims_test.py"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

from report.claims.billion_hits import billion_hits
from report.claims.claims import (
    constant_gather,
    constant_insert,
    constant_memory,
    faster_gather,
    tracing_speed,
    verdict_by_spread,
)
from report.claims.report import images
from report.claims.study_claims import converges, crossing_words, normal_maps
from report.compare.baselines import GATHER_US, MAP_SECONDS, is_as_accurate, strongest
from report.compare.comparison import INCREMENTAL, LIGHT_MAP, PAPER_LIGHT_MAP, PHOTON_MAP, Comparison
from report.compare.memory_wall import growth, wall_bytes
from report.study.methods import REFERENCE_LIGHT_MAP, TRADITIONAL_LIGHT_MAP
from known_methods import facts_of

TEXELS = 1000
TIMES = ("making_room_seconds", "trace_and_insert_seconds", "build_seconds", "gather_us_per_query")


def row(method, hits, noise=0.01, scene="room", repetitions=5, **times):
    """Times that are not given are 1."""
    made = {
        "scene": scene,
        "repetitions": repetitions,
        **facts_of(method),
        "hits_asked": hits,
        "hits": hits,
        "texels": TEXELS,
        "hits_per_texel": hits / TEXELS,
        "bytes": times.pop("bytes", 1e6),
    }
    insert_ns = times.pop("insert_ns", 1.0)
    made |= {"trace_seconds": hits * 1e-9, "ratio_to_null_sink": 1 + insert_ns}  # 1 ns a hit
    made["ratio_to_null_sink_range"] = [1 + insert_ns * (1 - noise), 1 + insert_ns * (1 + noise)]
    for name in TIMES:
        value = times.pop(name, 1.0)
        made |= {name: value, name + "_range": [value * (1 - noise), value * (1 + noise)]}
    return made | times


def skipped(method, hits, needed, wall):
    return {"scene": "room", **facts_of(method), "hits_asked": hits, "skipped": "needs much", "needed_bytes": needed, "max_memory_bytes": wall}


def write_comparison(folder, rows):
    document = {"context": {}, "rows": rows}
    (Path(folder) / "compare.json").write_text(json.dumps(document), encoding="utf-8")
    return Comparison(folder)


def comparison(rows):
    with tempfile.TemporaryDirectory() as folder:
        return write_comparison(folder, rows)


COMPACT = "photonmap/compact/k50/disc"
GRID = "photonmap/grid/r0.003/disc"


class Compared(unittest.TestCase):
    def test_spread(self):
        for spread, sure, expected in (
            (1.0, 1.0, "confirmed"),
            (1.3, 1.1, "not decided"),
            (1.3, 1.25, "refuted"),
        ):
            self.assertEqual(verdict_by_spread({"a": spread}, {"a": sure}, 1.2), expected)
        self.assertEqual(verdict_by_spread({"a": 1.3, "b": 1.0}, {"a": 1.25, "b": 1.0}, 1.2), "conditional")

    def test_tracing_speed(self):
        def verdict(incremental, bulk):
            sizes = (1000, 10_000)
            rows = [row(LIGHT_MAP, hits) for hits in sizes]
            rows += [row(INCREMENTAL, hits, build_seconds=t) for hits, t in zip(sizes, incremental)]
            rows += [row(PHOTON_MAP, hits, build_seconds=t) for hits, t in zip(sizes, bulk)]
            return tracing_speed(comparison(rows)).verdict

        self.assertEqual(verdict((2, 2), (2, 2)), "confirmed")
        self.assertEqual(verdict((0.5, 0.5), (0.5, 0.5)), "refuted")
        self.assertEqual(verdict((2, 2), (0.5, 0.5)), "conditional")
        self.assertEqual(verdict((0.5, 2), (0.5, 2)), "conditional")
        self.assertEqual(verdict((1, 1), (1, 1)), "not decided")  # the ranges touch

    def test_the_papers_gather_is_judged_by_itself(self):
        rows = [row(LIGHT_MAP, 10**4, gather_us_per_query=5.0), row(PAPER_LIGHT_MAP, 10**4, gather_us_per_query=0.1),
                row(INCREMENTAL, 10**4), row(PHOTON_MAP, 10**4)]
        both = comparison(rows)
        self.assertEqual(faster_gather(both, None).verdict, "refuted")
        self.assertEqual(faster_gather(both.judging(PAPER_LIGHT_MAP), None).verdict, "confirmed")

    def test_making_room_is_part_of_the_time(self):
        rows = [row(LIGHT_MAP, 1000, making_room_seconds=2), row(INCREMENTAL, 1000), row(PHOTON_MAP, 1000)]
        self.assertEqual(tracing_speed(comparison(rows)).verdict, "refuted")

    def test_both_sums_are_given_where_preparation_was_timed(self):
        rows = [row(LIGHT_MAP, 1000, prepare_seconds=9)] + [row(m, 1000, build_seconds=4, prepare_seconds=0) for m in (INCREMENTAL, PHOTON_MAP)]
        found = tracing_speed(comparison(rows))
        self.assertEqual(found.verdict, "confirmed")
        self.assertIn("for the first map of a scene, its preparation included: refuted", found.condition)
        self.assertIn("With the preparation of the scene: flann-incremental: room 0.50 x at 1 k", found.measured)

    def test_where_it_loses_is_said_though_the_rest_is_not_decided(self):
        rows = [row(m, hits) for m in (LIGHT_MAP,) for hits in (1000, 10_000)]
        rows += [row(m, hits, build_seconds=t) for m in (INCREMENTAL, PHOTON_MAP) for hits, t in ((1000, 0.1), (10_000, 1))]
        found = tracing_speed(comparison(rows))
        self.assertEqual(found.verdict, "not decided")
        self.assertIn("false in every scene at 1 k", found.condition)
        self.assertIn("fails at 1 k hits, else not decided", found.plain)

    def test_one_run_never_decides(self):
        few = [row(LIGHT_MAP, 1000, repetitions=4), row(INCREMENTAL, 1000, build_seconds=5), row(PHOTON_MAP, 1000, build_seconds=5)]
        found = tracing_speed(comparison(few))
        self.assertEqual(found.verdict, "not decided")
        self.assertIn("0 of 1 scenes with 5 runs", found.condition)
        self.assertIn("Beside today's strongest photon map: not decided.", found.plain)
        large = [row(m, 10**8, repetitions=3, build_seconds=t) for m, t in ((LIGHT_MAP, 1), (INCREMENTAL, 5), (PHOTON_MAP, 5))]
        self.assertEqual(tracing_speed(comparison(large)).verdict, "confirmed")

    def test_a_size_is_judged_where_every_scene_has_it(self):
        def rows(scene, sizes):
            return [row(m, hits, scene=scene, build_seconds=t) for hits in sizes for m, t in ((LIGHT_MAP, 1), (INCREMENTAL, 5), (PHOTON_MAP, 5))]

        found = tracing_speed(comparison(rows("room", (1000, 10_000)) + rows("hall", (1000,))))
        self.assertEqual(found.verdict, "confirmed")
        self.assertIn("not judged at 10 k: 1 of 2 scenes with 5 runs", found.condition)
        self.assertIn("at 1 k hits", found.figure)
    def test_constant_insert_looks_from_one_hit_per_texel_on(self):
        rows = [row(LIGHT_MAP, hits, insert_ns=t) for hits, t in ((100, 9), (1000, 1), (10_000, 1.1))]
        self.assertEqual(constant_insert(comparison(rows)).verdict, "confirmed")
        rows.append(row(LIGHT_MAP, 100_000, insert_ns=2))
        self.assertEqual(constant_insert(comparison(rows)).verdict, "refuted")
        self.assertEqual(constant_insert(comparison(rows[:2])).verdict, "not measured yet")
        rows[-1]["repetitions"] = 1
        self.assertEqual(constant_insert(comparison(rows)).verdict, "confirmed")

    def test_constant_within_the_noise_is_not_decided(self):
        rows = [row(LIGHT_MAP, hits, noise=1.0, insert_ns=t) for hits, t in ((1000, 1), (10_000, 1.4))]
        found = constant_insert(comparison(rows))
        self.assertEqual(found.verdict, "not decided")
        self.assertIn("may be noise", found.plain)

    def test_constant_memory_and_gather(self):
        rows = [row(LIGHT_MAP, 1000), row(LIGHT_MAP, 10_000)]
        self.assertEqual(constant_memory(comparison(rows)).verdict, "confirmed")
        self.assertEqual(constant_gather(comparison(rows)).verdict, "confirmed")
        rows.append(row(LIGHT_MAP, 100_000, bytes=2e6, gather_us_per_query=2))
        self.assertEqual(constant_memory(comparison(rows)).verdict, "refuted")
        self.assertEqual(constant_gather(comparison(rows)).verdict, "refuted")
        noisy = [row(LIGHT_MAP, 1000), row(LIGHT_MAP, 10_000, noise=0.3, gather_us_per_query=1.3)]
        self.assertEqual(constant_gather(comparison(noisy)).verdict, "not decided")

    def test_faster_gather_judges_above_one_hit_per_texel(self):
        def verdict(below, above):
            rows = [row(LIGHT_MAP, 100), row(LIGHT_MAP, 10_000)]
            rows += [row(PHOTON_MAP, 100, gather_us_per_query=below)]
            rows += [row(PHOTON_MAP, 10_000, gather_us_per_query=above)]
            return faster_gather(comparison(rows), None).verdict

        self.assertEqual(verdict(0.5, 2), "confirmed")
        self.assertEqual(verdict(2, 0.5), "refuted")


class AgainstTheStrongest(unittest.TestCase):
    def test_it_is_found_by_measurement(self):
        rows = [row(PHOTON_MAP, 1000, build_seconds=3), row(COMPACT, 1000, build_seconds=2), row(INCREMENTAL, 1000, build_seconds=0.1)]
        rows += [row(PHOTON_MAP, 10_000, build_seconds=3), row(COMPACT, 10_000, build_seconds=4)]
        made = comparison(rows)
        best = strongest(made, MAP_SECONDS)
        self.assertEqual(best.row("room", 1000)["method"], COMPACT)  # flann-incremental is not exact
        self.assertEqual(best.row("room", 10_000)["method"], PHOTON_MAP)
        self.assertIsNone(best.row("room", 100))

    def test_a_grid_counts_among_gathers_where_its_error_is_no_greater(self):
        made = comparison([row(PHOTON_MAP, 1000, build_seconds=3), row(GRID, 1000, gather_us_per_query=0.1)])
        self.assertEqual(strongest(made, MAP_SECONDS).row("room", 1000)["method"], GRID)

        def fastest(study):
            return strongest(made, GATHER_US, is_as_accurate(made, study)).row("room", 1000)["method"]

        def study(error_of_grid):
            points = {"photonmap/flann/k50/disc": 0.02, "photonmap/flann/r0.003/disc": error_of_grid}
            methods = {m: [{"hits_asked": 1000, "error": e, "error_band": [0.9 * e, 1.1 * e]}] for m, e in points.items()}
            return {"scenes": {"room": {"methods": methods}}}

        self.assertEqual(fastest(study(0.02)), GRID)
        self.assertEqual(fastest(study(0.03)), PHOTON_MAP)
        self.assertEqual(fastest(None), PHOTON_MAP)

    def test_both_verdicts_are_given(self):
        rows = [row(LIGHT_MAP, 10_000), row(INCREMENTAL, 10_000, build_seconds=5, gather_us_per_query=5),
                row(PHOTON_MAP, 10_000, build_seconds=3, gather_us_per_query=3)]
        fast = [row(COMPACT, 10_000, build_seconds=0.1, gather_us_per_query=0.1)]
        for judge in (tracing_speed, lambda c: faster_gather(c, None)):
            against_flann, against_all = judge(comparison(rows)), judge(comparison(rows + fast))
            self.assertEqual((against_flann.incremental, against_flann.strongest), ("confirmed", "confirmed"))
            self.assertEqual((against_all.verdict, against_all.incremental, against_all.strongest), ("conditional", "confirmed", "refuted"))
            self.assertIn("compact", against_all.measured)
            one_side = judge(comparison(rows[:2]))
            self.assertEqual((one_side.verdict, one_side.incremental, one_side.strongest), ("confirmed", "confirmed", "not measured"))

    def test_constancy_is_worth_nothing_where_the_photon_map_is_constant_too(self):
        def sides(judge, **grown):
            rows = [row(m, h, build_seconds=0) for m in (LIGHT_MAP, COMPACT) for h in (1000, 10_000)]
            rows += [row(INCREMENTAL, 1000, build_seconds=0), row(INCREMENTAL, 10_000, build_seconds=0, **grown)]
            found = judge(comparison(rows))
            return found.verdict, found.incremental, found.strongest

        same = "no difference: it does not grow either"
        self.assertEqual(sides(constant_insert, insert_ns=2), ("confirmed", "confirmed", same))
        self.assertEqual(sides(constant_gather, gather_us_per_query=2), ("confirmed", "confirmed", same))
        self.assertEqual(sides(constant_memory, bytes=1e7), ("confirmed", "confirmed", same))

    def test_a_hit_has_its_share_of_the_build(self):
        rows = [row(m, h, insert_ns=100) for m in (LIGHT_MAP, COMPACT) for h in (1000, 10_000)]
        for r in rows:
            r["build_seconds"] = {1000: 1e-4, 10_000: 1e-2}[r["hits"]] if r["method"] == COMPACT else 0
            r["build_seconds_range"] = [r["build_seconds"]] * 2
        # 100 + 100 ns, then 100 + 1000.
        self.assertEqual(constant_insert(comparison(rows)).strongest, "confirmed")
        for r in rows:  # a share that falls is no growth
            r["build_seconds"] = 1e-4 if r["method"] == COMPACT else 0
            r["build_seconds_range"] = [r["build_seconds"]] * 2
        self.assertTrue(constant_insert(comparison(rows)).strongest.startswith("no difference"))


class ABillion(unittest.TestCase):
    WALL = 20 * 2**30

    def rows(self, gather_at_a_billion=1.0, light_hits=10**9):
        rows = [row(LIGHT_MAP, h, gather_us_per_query=gather_at_a_billion if h == 10**9 else 1.0) for h in (10**5, 10**7, light_hits)]
        for r in rows:
            r |= {"threads": 2, "peak_growth_bytes": 2**27, "insert_bytes": 2**26, "max_memory_bytes": self.WALL}
        return rows

    def photons(self, method, bytes_per_hit):
        rows = [row(method, h) for h in (10**6, 10**7)]
        for r in rows:
            r |= {"peak_growth_bytes": 2e7 + bytes_per_hit * r["hits"], "max_memory_bytes": self.WALL}
        return rows

    def test_billion_hits(self):
        found = billion_hits(comparison(self.rows() + self.photons(INCREMENTAL, 136) + self.photons(COMPACT, 24)))
        self.assertEqual((found.verdict, found.incremental, found.strongest), ("confirmed", "confirmed", "confirmed"))
        self.assertIn("at its fullest 128\u00a0MiB", found.measured)
        self.assertIn("at 1e7 hits 128\u00a0MiB", found.measured)
        self.assertIn("at 894 M hits, a billion would take 22.4\u00a0GiB", found.measured)
        self.assertEqual(billion_hits(comparison(self.rows() + self.photons(COMPACT, 20))).strongest, "no difference: it fits as well")
        alone = billion_hits(comparison(self.rows()))
        self.assertEqual((alone.verdict, alone.incremental, alone.strongest), ("confirmed", "not measured", "not measured"))
        self.assertEqual(billion_hits(comparison(self.rows(light_hits=10**8))).verdict, "not measured yet")

    def test_a_line_needs_a_million_hits(self):
        rows = [row(PHOTON_MAP, 10**5) | {"peak_growth_bytes": 1e7}, skipped(PHOTON_MAP, 10**9, 8e10, self.WALL)]
        self.assertIsNone(growth(comparison(rows), "room", PHOTON_MAP))
        self.assertEqual(wall_bytes(comparison(rows), "room"), self.WALL)

    def test_the_line_goes_through_the_last_rows(self):
        grows = growth(comparison(self.photons(COMPACT, 24)), "room", COMPACT)
        self.assertAlmostEqual(grows.per_hit, 24)
        self.assertAlmostEqual(grows.bytes_at(1e9), 2.402e10)
        self.assertAlmostEqual(grows.hits_at(grows.bytes_at(5e8)), 5e8)
        light = growth(comparison(self.rows()), "room", LIGHT_MAP)
        self.assertEqual((light.bytes_at(1e12), light.hits_at(1e12)), (2**27, None))

    def test_gather_at_a_billion_hits_is_part_of_constant_gather(self):
        self.assertEqual(constant_gather(comparison(self.rows())).verdict, "confirmed")
        slow = constant_gather(comparison(self.rows(gather_at_a_billion=1.1)))  # within 15 %, not within 5 %
        self.assertEqual(slow.verdict, "refuted")
        self.assertIn("within 5 %): refuted", slow.measured)
        self.assertIn("1e9 hits against 1e5: not measured", constant_gather(comparison(self.rows(light_hits=10**8))).measured)

    def test_the_peak_is_held_to_its_bound(self):
        rows = self.rows()
        self.assertIn("within the bound of 134\u00a0MiB", constant_memory(comparison(rows)).measured)
        rows[-1]["peak_growth_bytes"] = 2**28
        self.assertIn("past the bound", constant_memory(comparison(rows)).measured)


def summary(methods, slope=-1.0):
    slopes = {name: {"variance": {"value": slope}} for name in methods}
    return {
        "context": {"settings": f"texels={TEXELS} max-radius=auto"},
        "scenes": {"room": {"methods": methods, "slopes": slopes, "more_accurate_than": {}}},
    }


def point(bias_sq, half_band, tilted_bias_sq=None):
    tilt = [] if tilted_bias_sq is None else [
        {"degrees": [30, 40], "points": 100, "bias_sq": tilted_bias_sq,
         "bias_sq_band": [tilted_bias_sq - half_band, tilted_bias_sq + half_band]}
    ]
    return {
        "hits": 1e6,
        "error": 0.01 + bias_sq,
        "variance": 0.01,
        "bias_sq": bias_sq,
        "bias_sq_band": [bias_sq - half_band, bias_sq + half_band],
        "tilt": tilt,
    }


class Studied(unittest.TestCase):
    def test_converges(self):
        def verdict(bias_sq, half_band, slope):
            return converges(summary({REFERENCE_LIGHT_MAP: [point(bias_sq, half_band)]}, slope)).verdict

        self.assertEqual(verdict(1e-4, 2e-4, -1.0), "confirmed")  # no floor is seen
        self.assertEqual(verdict(1e-3, 1e-4, -0.95), "conditional")
        self.assertEqual(verdict(1e-3, 1e-4, -0.8), "refuted")

    def test_normal_maps(self):
        def verdict(mine, flat, half_band):
            methods = {
                REFERENCE_LIGHT_MAP: [point(0, half_band, mine)],
                TRADITIONAL_LIGHT_MAP: [point(0, half_band, flat)],
            }
            return normal_maps(summary(methods)).verdict

        self.assertEqual(verdict(0.01, 0.3, 0.001), "confirmed")
        self.assertEqual(verdict(0.1, 0.3, 0.001), "conditional")
        self.assertEqual(verdict(0.01, 0.3, 0.1), "conditional")  # not sure enough
        self.assertEqual(verdict(0.3, 0.3, 0.001), "refuted")

    def test_crossings_in_words(self):
        def words(intervals, crossing):
            return crossing_words({"range": [1e3, 1e6], "intervals": intervals, "crossing": crossing}, TEXELS)

        self.assertEqual(words([[2e4, None]], 2e4), "from 2e+04 hits (20 per texel)")
        self.assertEqual(words([[None, 2e4]], 2e4), "up to 2e+04 hits (20 per texel)")
        self.assertEqual(words([[None, None]], None), "everywhere")
        self.assertEqual(words([], None), "nowhere up to 1e+06")


class Images(unittest.TestCase):
    def test_engines_share_a_picture(self):
        methods = (COMPACT, "photonmap/flann/k50/disc", "photonmap/flann/k200/disc", GRID, LIGHT_MAP)
        with tempfile.TemporaryDirectory() as folder:
            found = write_comparison(folder, [row(method, 1000) for method in methods])
            (Path(folder) / "images").mkdir()
            for method in methods:
                (Path(folder) / "images" / f"room-{method.replace('/', '-')}.png").touch()
            shown = [line for line in images(found) if line.startswith("![")]
        self.assertEqual(
            [line[len("![room, ") : line.index("]")] for line in shown],
            [COMPACT, "photonmap/flann/k200/disc", GRID, LIGHT_MAP],
        )


if __name__ == "__main__":
    unittest.main()
