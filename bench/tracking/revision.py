"""A revision of the repository and its programs, built below build/track/COMMIT."""

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from input_error import InputError
from progress import say

# Flags rather than presets: a revision of before a preset can be measured, too. These are the preset `release`...
NATIVE = ("-DCMAKE_BUILD_TYPE=Release", "-DSHLMBENCH_NATIVE=ON")
# ...and what callgrind can run, whose processor has no AVX-512.
COUNTABLE = ("-DCMAKE_BUILD_TYPE=Release", "-DSHLMBENCH_NATIVE=OFF", "-DCMAKE_CXX_FLAGS=-march=x86-64-v3")


def git(folder, *arguments):
    return subprocess.run(["git", "-C", folder, *arguments], capture_output=True, text=True)


@dataclass(frozen=True)
class Revision:
    commit: str  # 12 digits
    folder: Path  # of source/, native/, countable/ and twin/


def resolve(repository, name):
    """Throws InputError where there is no such commit."""
    found = git(repository, "rev-parse", "--verify", "--quiet", "--end-of-options", name + "^{commit}")
    if found.returncode != 0:
        raise InputError(f"{name}: no such revision")
    commit = found.stdout.strip()[:12]
    return Revision(commit, repository / "build" / "track" / commit)


def require_clean(repository):
    """What lies in results/ does not make a program another one (bench/setup/commit.cmake)."""
    if git(repository, "diff", "--quiet", "HEAD", "--", ".", ":(exclude)results").returncode != 0:
        raise InputError("the working tree has changes that no revision names: commit them, or say which HEAD is meant")


def check_out(repository, revision):
    """A clone that borrows the repository's objects: nothing is left in the repository when build/track is deleted."""
    source = revision.folder / "source"
    if not (source / ".git").exists():
        source.parent.mkdir(parents=True, exist_ok=True)
        git(repository, "clone", "--quiet", "--shared", "--no-checkout", repository, source)
    if git(source, "checkout", "--quiet", "--force", "--detach", revision.commit).returncode != 0:
        raise InputError(f"{revision.commit}: cannot be checked out in {source}")
    return source


def build(source, folder, flags, targets):
    """Does only what is not done yet. With CMAKE_CXX_COMPILER_LAUNCHER=ccache, which cmake heeds, what the revisions share is
    compiled once: below CCACHE_BASEDIR paths do not matter."""
    log = folder.with_suffix(".log")
    environment = {"CCACHE_BASEDIR": str(folder.parent.parent), **os.environ}
    with log.open("w", encoding="utf-8") as text:
        for command in (
            ["cmake", "-G", "Ninja", "-S", source, "-B", folder, *flags],
            ["cmake", "--build", folder, "--target", *targets],
        ):
            if subprocess.run(command, stdout=text, stderr=text, env=environment).returncode != 0:
                raise InputError(f"{source}: does not build, see {log}")
    return folder


def native_build(repository, revision):
    """The folder of shlmbench, shlmbench_micro and scenes/."""
    say(f"building {revision.commit}")
    targets = ("shlmbench", "shlmbench_micro", "scenes")
    return build(check_out(repository, revision), revision.folder / "native", NATIVE, targets)


def countable_build(repository, revision):
    """The folder of a shlmbench_micro that callgrind can run."""
    say(f"building {revision.commit} for callgrind")
    targets = ("shlmbench_micro", "scenes")
    return build(check_out(repository, revision), revision.folder / "countable", COUNTABLE, targets)


def twin_of(program, revision):
    """A second copy of a program, to compare it with itself."""
    twin = revision.folder / "twin" / program.name
    twin.parent.mkdir(exist_ok=True)
    shutil.copy2(program, twin)
    os.sync()  # not while the first runs are timed
    return twin
