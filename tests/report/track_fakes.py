"""A repository of programs that only say how long they took, for track_test.py to compare two revisions of.

Its times are noisy by about half a percent, from counters rather than clocks, so that a test gives the same answer each time."""

import os
import shutil
import subprocess
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

CMAKE = """
    cmake_minimum_required(VERSION 3.25)
    project(fake NONE)
    foreach(program shlmbench shlmbench_micro)
      add_custom_target(${program} COMMAND cp ${CMAKE_SOURCE_DIR}/${program} ${CMAKE_BINARY_DIR}/)
    endforeach()
    add_custom_target(scenes COMMAND mkdir -p scenes && cp ${CMAKE_SOURCE_DIR}/cornell.glb scenes/)
"""

MICRO = """\
    #!/usr/bin/python3 -SE
    import json, pathlib, random, re, sys, time
    SECONDS = {seconds!r}  # None: fails; 0: takes for ever
    INSTRUCTIONS = {instructions!r}
    options = dict(option.lstrip("-").partition("=")[::2] for option in sys.argv[1:])
    if "benchmark_list_tests" in options:
        print(*SECONDS, sep="\\n")
        sys.exit()
    (name,) = [name for name in SECONDS if re.search(options["benchmark_filter"], name)]
    if SECONDS[name] == 0:
        time.sleep(600)
    counter = pathlib.Path(sys.argv[0] + ".count")
    count = int(counter.read_text()) + 1 if counter.exists() else 0
    counter.write_text(str(count))
    noise = random.Random(f"{{pathlib.Path(sys.argv[0]).parent.name}} {{INSTRUCTIONS}} {{count}}").gauss(0, 0.005)
    run = {{"name": name, "run_type": "iteration", "iterations": 1, "time_unit": "ms"}}
    if SECONDS[name] is None:
        run |= {{"error_occurred": True, "error_message": "the mean is wrong"}}
    else:
        run["real_time"] = run["cpu_time"] = 1e3 * SECONDS[name] * (1 + noise)
    print(json.dumps({{"benchmarks": [run, run | {{"run_type": "aggregate", "cpu_time": 1e9}}]}}))
"""

SHLMBENCH = """\
    #!/usr/bin/python3 -SE
    import pathlib, random, sys
    ERROR = {error!r}
    if sys.argv[1] == "render":
        method, seed, out = (sys.argv[sys.argv.index(option) + 1] for option in ("--method", "--seed", "--out"))
        noise = random.Random(f"{{method}} {{seed}} {{ERROR}}").gauss(0, 0.005)
        picture = pathlib.Path(out).with_suffix(".png")
        if picture.exists() and picture.read_text() != sys.argv[0]:
            sys.exit("shlmbench: --out: is there already and was not made by this command")
        picture.write_text(sys.argv[0])
        pathlib.Path(out).write_text(str(ERROR * (1 + noise)))
    else:
        print('{{"relative_rms": ' + pathlib.Path(sys.argv[2]).read_text() + "}}")
"""

# Instead of counting it looks up what the program says of itself.
VALGRIND = """\
    #!/usr/bin/python3 -SE
    import pathlib, re, subprocess, sys
    (out,) = [option.partition("=")[2] for option in sys.argv if option.startswith("--callgrind-out-file=")]
    command = sys.argv[[option.startswith("-") for option in sys.argv[1:]].index(False) + 1 :]
    count = re.search(r"INSTRUCTIONS = (\\d+)", pathlib.Path(command[0]).read_text()).group(1)
    end = "--dump-before=benchmark::State::FinishKeepRunning()"
    pathlib.Path(out).write_text(f"desc: Trigger: {end}\\nsummary: {count}\\n")
    sys.exit(subprocess.run(command).returncode)
"""


def write_program(file, text):
    file.write_text(textwrap.dedent(text), encoding="utf-8")
    file.chmod(0o755)


class FakeRepository:
    def __init__(self, folder):
        self.folder = Path(folder) / "repository"
        self.bin = Path(folder) / "bin"
        self.bin.mkdir()
        write_program(self.bin / "valgrind", VALGRIND)
        ignored = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / "bench" / "tracking", self.folder / "bench" / "tracking", ignore=ignored)
        shutil.copytree(ROOT / "bench" / "report", self.folder / "bench" / "report", ignore=ignored)
        shutil.copy2(ROOT / "bench" / "track", self.folder / "bench" / "track")
        (self.folder / "results" / "references").mkdir(parents=True)
        (self.folder / "results" / "references" / "cornell.exr").write_text("a reference")
        (self.folder / ".gitignore").write_text("/build/\n__pycache__/\n")
        self.git("init", "--quiet")

    def git(self, *arguments):
        who = ["-c", "user.name=test", "-c", "user.email=test", "-c", "commit.gpgsign=false"]
        done = subprocess.run(["git", *who, *arguments], cwd=self.folder, check=True, capture_output=True, text=True)
        return done.stdout.strip()

    def commit(self, seconds, instructions=1000, error=0.1, scene="a scene", cmake=CMAKE):
        """A revision with these benchmarks; returns its name."""
        (self.folder / "CMakeLists.txt").write_text(textwrap.dedent(cmake), encoding="utf-8")
        (self.folder / "cornell.glb").write_text(scene)
        write_program(self.folder / "shlmbench_micro", MICRO.format(seconds=seconds, instructions=instructions))
        write_program(self.folder / "shlmbench", SHLMBENCH.format(error=error))
        self.git("add", ".")
        self.git("commit", "--quiet", "--allow-empty", "-m", "revision")
        return self.git("rev-parse", "HEAD")

    def start(self, *arguments):
        """bench/track, in a process group of its own."""
        environment = {**os.environ, "PATH": f"{self.bin}:{os.environ['PATH']}"}
        return subprocess.Popen(
            [self.folder / "bench" / "track", *arguments],
            env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
        )  # fmt: skip

    def track(self, *arguments):
        """(exit code, stdout, stderr)"""
        process = self.start(*arguments)
        out, err = process.communicate()
        return process.returncode, out, err

    def history_files(self):
        return sorted((self.folder / "results").glob("history/*.jsonl"))
