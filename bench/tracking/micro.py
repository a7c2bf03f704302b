"""One run of shlmbench_micro, a process of its own: memory lies elsewhere each time, and that is part of the noise."""

import json
import re
import statistics

from process import MeasurementFailed, output_of

MIN_SECONDS = 0.05  # per repetition
REPETITIONS = 3
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def names(program):
    return output_of([program, "--benchmark_list_tests"]).split()


def exactly(name):
    """The filter that takes this benchmark alone."""
    return "--benchmark_filter=^" + re.sub(r"([.\[\]()*+?{}|^$\\])", r"\\\1", name) + "$"


def runs_in(json_text):
    """The repetitions that Google Benchmark's output holds, without its own statistics of them."""
    runs = [r for r in json.loads(json_text)["benchmarks"] if r.get("run_type", "iteration") == "iteration"]
    for one in runs:
        if one.get("error_occurred"):
            raise MeasurementFailed(one["error_message"])
    return runs


def seconds(program, name):
    """Of one iteration, the median of the repetitions, by the clock that the benchmark is registered with. Throws
    MeasurementFailed."""
    options = ["--benchmark_format=json", f"--benchmark_min_time={MIN_SECONDS}", f"--benchmark_repetitions={REPETITIONS}"]
    runs = runs_in(output_of([program, exactly(name), *options]))
    clock = "real_time" if name.endswith("/real_time") else "cpu_time"
    return statistics.median(one[clock] * UNITS[one["time_unit"]] for one in runs)
