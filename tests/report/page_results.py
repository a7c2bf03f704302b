"""A small folder of results of every kind, for the tests of the page: a synthetic study with its pictures, verdicts, a comparison, stability cases, fits, history."""

import json
from pathlib import Path

import synthetic_realtime
from known_methods import facts_of
from report.study.methods import REFERENCE_PHOTON_MAP
from report.study.report import Report
from report.study.summary import summary
from study_laws import fixed_k_law, growing_k_law, light_map_law, radius_law
from synthetic_study import CONTEXT, Law, Plan, write_study

SHLM, SMALL, FLAT, FEWER = "shlm/L2/radiance/surface4", "shlm/L2/radiance/surface4/t16384", "shlm/L0/normalised/surface4", "shlm/F1/radiance/surface4"
NEAREST, GROWING, RADIUS = REFERENCE_PHOTON_MAP, "photonmap/compact/k0.05n23/cone", "photonmap/compact/r0.01/disc"
METHODS = {
    SHLM: light_map_law(),
    SMALL: light_map_law(2e-4, 80),
    FLAT: light_map_law(3e-3, 300),
    FEWER: Law(lambda h: 50 / h, lambda h: 1e-5, lambda h: 1e-6 * h, bytes=lambda h: 500e6, texels=100),  # accurate, and large
    NEAREST: fixed_k_law(),
    GROWING: growing_k_law(),
    RADIUS: radius_law(),
}
SCENES, SIZES = ("cornell", "bumpy"), (10_000, 100_000, 1_000_000)
HOSTILE = "</script><script>alert(1)</script><!-- & \"quotes\""  # what a text of a result must not be able to do


def write(file, document):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(document), encoding="utf-8")


def write_summary(folder):
    """As bench/report study does, without its charts."""
    report = Report(folder)
    write(Path(folder) / "summary.json", summary(report.study, report.curves, report.findings, report.groups))


def add_study(folder, plan=None):
    write_study(folder, plan or Plan(METHODS, scenes=SCENES, sizes=SIZES, seeds=3, points=300, has_pictures=True))
    write_summary(folder)


def finding(verdict, condition="", incremental="", strongest=""):
    return {"claim": "c", "says": "s", "verdict": verdict, "measured": "all of it", "incremental": incremental, "strongest": strongest,
            "condition": condition, "figure": "1.5 x", "scenes": ["cornell"], "runs": [5, 9]}


SIDES = "flann-incremental: conditional (true in every scene from 1 M hits on, not at 100 k and below); the strongest engine: not decided (false in every scene at 10 k)"


def verdict(claim, word, found, condition="", folder="side-by-side"):
    return {"claim": claim, "says": f"The paper says {claim}", "verdict": word, "condition": condition, "figure": "1.5 x at 1 M hits", "rests_on": ["a folder"],
            "link": f"{folder}/report.md", "findings": {folder: found}}


def verdicts():
    return [
        verdict("tracing-speed", "conditional", finding("conditional", SIDES, "conditional", "not decided"), "It holds from 1 M hits on."),
        verdict("constant-memory", "confirmed", finding("confirmed")),
        verdict("constant-gather", "not decided", finding("not decided", "not judged at 10 M: 0 of 4 scenes with 5 runs"), "Too few runs at 10 M hits."),
        verdict("unheard-of", "refuted", finding("refuted", HOSTILE)),
    ]


def point(at, predicted, mean, band=0.1, passed=True):
    return {"at": at, "predicted": predicted, "mean": mean, "confidence": 0.01, "band": band, "passed": passed}


def case(name, points, expected="equal", passed=True):
    return {"name": name, "purpose": HOSTILE, "scene": "A floor.", "swept": "width", "measured": "irradiance", "theory": "1", "advice": "None.", "seeds": 32,
            "passed": passed, "curves": [{"name": "light map", "expected": expected, "points": points}]}


def stability():
    rows = [case("calm", [point(0, 1, 1.01)]), case("close", [point(0, 1, 1.09), point(1, 1, 1)]), case("broken", [point(0, 1, 1.2, passed=False)], passed=False),
            case("shown", [point(0, 1, 5)], "shown")]
    return {"context": {**CONTEXT, "commit": "bbbbbbbbbbbb"}, "rows": rows}


def fit():
    def choice(method, size):
        return {"method": method, "hits": 5e5, "error": 0.08, "seconds": 0.1, "bytes": size}

    runs = [{"seed": seed, "error": error, "worst_share": 0.1, "seconds": 0.1, "bytes": 1e4} for seed, error in ((2, 0.09), (3, 0.11))]
    return {"context": CONTEXT, "scene": "cornell", "target": 0.1, "least": "bytes",
            "light_map": {"reached": True, "choice": choice(SHLM, 1e4), "verified": runs},
            "photon_map": {"reached": False, "reason": "noise"}}


def elsewhere():
    """One scene that is as it should be, one that was refused."""
    error = {"value": 0.004, "chance": 0.001}
    row = {"asked": "shlm", "method": SHLM, "hits": 1e6, "mean": error, "worst_region": error, "rms": 0.03}
    hall = {"name": "hall", "context": {**CONTEXT, "commit": "dddddddddddd"}, "info": {"triangles": 1234}, "methods": [row],
            "reference": {"samples_per_pixel": 64, "relative_error": 0.01}, "fit": {"reason": "no time"}, "verdict": "within"}
    return {"scenes": [hall, {"name": "crypt", "failed": HOSTILE}]}


def entry(ratio, word):
    return {"base": 1.0, "head": ratio, "ratio": ratio, "interval": [ratio * 0.98, ratio * 1.02], "band": 0.05, "verdict": word}


def history():
    def line(kind, date, benchmarks, errors):
        return {"kind": kind, "date": date, "machine": {"name": "m"}, "base": "aaaaaaaaaaaa", "head": "bbbbbbbbbbbb", "pairs": 9, "finished": True,
                "missing": {"base": [], "head": []}, "scenes_differ": [], "benchmarks": benchmarks, "errors": errors}

    return [
        line("same build twice", "2026-01-01T00:00:00Z", {"trace": entry(1.0, "learnt")}, {}),
        line("two revisions", "2026-01-02T00:00:00Z", {"trace": entry(1.3, "slower"), "gather": entry(1.01, "same")}, {"cornell/shlm": entry(0.7, "better")}),
        line("two revisions", "2026-01-03T00:00:00Z", {"gather": entry(0.8, "faster"), "trace": {"verdict": "failed", "because": "it crashed"}}, {}),
    ]


COLUMNS = ("trace_seconds", "making_room_seconds", "trace_and_insert_seconds", "build_seconds", "gather_us_per_query", "gather_us_per_query_shuffled")


def comparison():
    """One size of two methods; the page takes pictures and provenance of it."""
    rows = [{"scene": "cornell", **facts_of(method), "hits_asked": 1000, "hits": 1000, "repetitions": 5, "bytes": 1e6, "texels": 100, **dict.fromkeys(COLUMNS, 1.0)}
            for method in (SHLM, NEAREST)]
    return {"context": {**CONTEXT, "commit": "cccccccccccc", "seed": 1, "repetitions": 5}, "rows": rows}


def write_results(root):
    """All of it, under `root`."""
    root = Path(root)
    add_study(root / "study")
    write(root / "verdicts.json", verdicts())
    write(root / "side-by-side" / "compare.json", comparison())
    (root / "side-by-side" / "report.md").write_text("# A report\n")
    write(root / "stability" / "stability.json", stability())
    write(root / "elsewhere" / "elsewhere.json", elsewhere())
    write(root / "realtime" / "realtime.json", synthetic_realtime.document())
    (root / "realtime" / "viewer-bumpy.html").write_text("<p>A page")
    (root / "elsewhere" / "report.md").write_text("# A report\n")
    write(root / "models" / "fit" / "cornell" / "10-bytes" / "fit.json", fit())
    (root / "history").mkdir()
    (root / "history" / "m.jsonl").write_text("".join(json.dumps(line) + "\n" for line in history()))
    return root
