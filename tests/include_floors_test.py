"""No floor includes what is above it: a list of floors, and whether every #include looks down."""

import re
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]

# From the ground up. Folders of one line are neighbours: they may not include each other. A folder that is part of another
# one stands for itself; its own files may always include each other.
FLOORS = [
    ["common/core"],
    ["common/scene", "common/gltf_writing"],
    ["common/estimator"],
    ["common/gltf", "common/tracer", "common/point_index", "common/image"],
    ["common/view", "common/difference"],
    ["common/reference"],
    ["photonmap/index", "shlm/basis"],
    ["photonmap", "shlm/layout"],
    ["shlm/sums"],
    ["shlm/map"],
    ["shlm/file", "shlm/adaptive"],
    ["bench/setup"],
    ["bench/contenders"],
    ["bench/contenders/engines", "bench/contenders/bases", "bench/export"] + [f"bench/experiments/{folder.name}" for folder in (ROOT / "bench/experiments").iterdir()],
    ["bench/experiments/stability/cases"],
    ["bench/app"],
]
SCENES = ("bench/scenes", ("common/core", "common/scene", "common/gltf_writing"))  # writes files and knows no renderer


def floor_of(folder):
    """(number, name) of the narrowest entry that holds the folder; None where there is none."""
    found = [(number, name) for number, floor in enumerate(FLOORS) for name in floor if folder == name or folder.startswith(name + "/")]
    return max(found, key=lambda entry: len(entry[1]), default=None)


def includes(file):
    return re.findall(r'^#include "([a-z_]+/[^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE)


def upward_includes(root):
    """Lines that say which include looks up, or sideways."""
    wrong = []
    for file in sorted(f for top in ("common", "photonmap", "shlm", "bench") for f in (root / top).rglob("*") if f.suffix in (".h", ".cpp")):
        folder = str(file.parent.relative_to(root))
        for target in includes(file):
            there = str(Path(target).parent)
            if not looks_down(folder, there):
                wrong.append(f"{file.relative_to(root)} includes {target}")
    return wrong


def looks_down(folder, target):
    if folder.startswith(SCENES[0]):
        return target.startswith(SCENES[0]) or target in SCENES[1]
    here, there = floor_of(folder), floor_of(target)
    if here is None or there is None:
        return False
    return there[1] == here[1] or there[0] < here[0]


class IncludeFloors(unittest.TestCase):
    def test_every_include_looks_down(self):
        self.assertEqual(upward_includes(ROOT), [])

    def test_a_planted_one_is_found(self):
        for place, target in [
            ("common/core/a.h", "common/scene/scene.h"),
            ("common/tracer/a.cpp", "photonmap/photon_map.h"),
            ("photonmap/a.h", "shlm/map/light_map.h"),
            ("shlm/layout/a.h", "shlm/sums/texel_sums.h"),
            ("bench/setup/a.h", "bench/contenders/contender.h"),
            ("bench/experiments/fit/a.cpp", "bench/experiments/study/study_plan.h"),
            ("bench/scenes/a.cpp", "common/tracer/ray_scene.h"),
            ("common/elsewhere/a.h", "common/core/vector.h"),
        ]:
            with tempfile.TemporaryDirectory() as folder, self.subTest(place):
                file = Path(folder) / place
                file.parent.mkdir(parents=True)
                file.write_text(f'#include <vector>\n\n#include "{target}"\n', encoding="utf-8")
                self.assertEqual(upward_includes(Path(folder)), [f"{place} includes {target}"])


if __name__ == "__main__":
    unittest.main()
