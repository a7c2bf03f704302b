"""Instructions of each small benchmark of one thread, counted by valgrind's callgrind: no noise, and no clock either.

Google Benchmark itself marks what is timed: callgrind begins to count where a benchmark's loop starts or resumes, and writes down
what it has where the loop pauses or ends. So the benchmarks of any revision can be counted without knowing of it.
"""

import os
import re
import shutil

from micro import exactly, runs_in
from process import MeasurementFailed, output_of

# Larger ones take minutes when they are emulated.
MOST = {"hits": 100_000, "texels": 65_536, "threads": 1}

END = "--dump-before=benchmark::State::FinishKeepRunning()"
OPTIONS = (
    "--tool=callgrind",
    "--combine-dumps=yes",
    "--zero-before=benchmark::State::StartKeepRunning()",
    "--zero-before=benchmark::State::ResumeTiming()",
    "--dump-before=benchmark::State::PauseTiming()",
    END,
)
DUMP = re.compile(r"^desc: Trigger: (.*?)$.*?^summary: (\d+)", re.MULTILINE | re.DOTALL)


def available():
    return shutil.which("valgrind") is not None


def is_countable(name):
    return all(int(value) <= MOST.get(key, int(value)) for key, value in re.findall(r"(\w+):(\d+)", name))


def counted(callgrind_text):
    """Up to the end of the benchmark's loop. Throws MeasurementFailed where it came to none, or to several."""
    dumps = DUMP.findall(callgrind_text)
    ends = [place for place, (trigger, _) in enumerate(dumps) if trigger == END]
    if len(ends) != 1:
        raise MeasurementFailed(f"under valgrind: the benchmark's loop ended {len(ends)} times instead of once")
    return sum(int(instructions) for _, instructions in dumps[: ends[0] + 1])


def on_one_core():
    """TBB then starts no second thread."""
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})


def count(program, name, out_file):
    """Of one iteration; the benchmarks' own seed is fixed. Throws MeasurementFailed."""
    out_file.unlink(missing_ok=True)
    command = ["valgrind", *OPTIONS, f"--callgrind-out-file={out_file}", program]
    command += ["--benchmark_min_time=0", "--benchmark_format=json", exactly(name)]
    linked_first = {**os.environ, "LD_BIND_NOW": "1"}  # looking up a symbol at its first call is not the benchmark's work
    (only,) = runs_in(output_of(command, env=linked_first, preexec_fn=on_one_core))
    return counted(out_file.read_text(encoding="utf-8")) / only["iterations"]
