"""The verdicts on the paper's claims, on tables made up for the purpose: claims_test.py"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "bench" / "report"))

from claims import constant_gather, constant_insert, constant_memory, faster_gather, tracing_speed, verdict_by_spread
from comparison import INCREMENTAL, LIGHT_MAP, PHOTON_MAP, Comparison
from study_claims import converges, crossing_words, normal_maps
from study_methods import REFERENCE_LIGHT_MAP, TRADITIONAL_LIGHT_MAP

TEXELS = 1000
TIMES = (
    "making_room_seconds",
    "trace_and_insert_seconds",
    "build_seconds",
    "insert_ns_per_hit",
    "gather_us_per_query",
)


def row(method, hits, noise=0.01, **times):
    """Times that are not given are 1."""
    made = {
        "scene": "room",
        "method": method,
        "hits_asked": hits,
        "hits": hits,
        "texels": TEXELS,
        "hits_per_texel": hits / TEXELS,
        "bytes": times.pop("bytes", 1e6),
    }
    for name in TIMES:
        value = times.get(name, 1.0)
        made |= {name: value, name + "_range": [value * (1 - noise), value * (1 + noise)]}
    return made


def comparison(rows):
    with tempfile.TemporaryDirectory() as folder:
        document = {"context": {}, "rows": rows}
        (Path(folder) / "compare.json").write_text(json.dumps(document), encoding="utf-8")
        return Comparison(folder)


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
        self.assertEqual(verdict((1, 1), (1, 1)), "refuted")  # no faster within the noise

    def test_making_room_is_part_of_the_time(self):
        rows = [row(LIGHT_MAP, 1000, making_room_seconds=2), row(INCREMENTAL, 1000), row(PHOTON_MAP, 1000)]
        self.assertEqual(tracing_speed(comparison(rows)).verdict, "refuted")

    def test_constant_insert_looks_from_one_hit_per_texel_on(self):
        rows = [row(LIGHT_MAP, hits, insert_ns_per_hit=t) for hits, t in ((100, 9), (1000, 1), (10_000, 1.1))]
        self.assertEqual(constant_insert(comparison(rows)).verdict, "confirmed")
        rows.append(row(LIGHT_MAP, 100_000, insert_ns_per_hit=2))
        self.assertEqual(constant_insert(comparison(rows)).verdict, "refuted")
        self.assertEqual(constant_insert(comparison(rows[:2])).verdict, "not measured yet")

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


if __name__ == "__main__":
    unittest.main()
