"""Is a .glb file read as glTF 2.0 says?"""

import json
import struct
import tempfile
import unittest
from pathlib import Path

import numpy as np

from glb_scene import read_scene
from input_error import InputError
from test_scenes import unit


def write_glb(document, binary):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    file = Path(tempfile.mkdtemp()) / "scene.glb"
    file.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return file


def small_document():
    """One triangle, mirrored, turned and moved; a spot; a lamp's material."""
    quarter = float(np.sqrt(0.5))
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"translation": [1, 2, 3], "children": [1, 2]},
            {"mesh": 0, "scale": [-2, 1, 1], "rotation": [0, quarter, 0, quarter]},
            {"rotation": [-quarter, 0, 0, quarter], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [
            {
                "emissiveFactor": [0.5, 1, 0],
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}},
            }
        ],
        "extensions": {
            "KHR_lights_punctual": {"lights": [{"type": "spot", "color": [1, 0, 0.5], "intensity": 8, "spot": {"outerConeAngle": 0.5}}]}
        },
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36}],
    }


class Reader(unittest.TestCase):
    binary = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32).tobytes()

    def test_transforms_materials_and_lights(self):
        scene = read_scene(write_glb(small_document(), self.binary))
        mesh, spot = scene.meshes[0], scene.spot_lights[0]
        # Scaled to (-2, 0, 0), turned about y to (0, 0, 2), moved.
        np.testing.assert_allclose(mesh.position, [[1, 2, 3], [1, 2, 5], [1, 3, 3]], atol=1e-6)
        corners = mesh.position[mesh.triangles[0]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        np.testing.assert_allclose(unit(normal), [1, 0, 0], atol=1e-6)  # +z, turned about y
        self.assertEqual((mesh.material.kind, mesh.material.emitted_radiance), ("diffuse", (2, 4, 0)))
        np.testing.assert_allclose(spot.position, [1, 2, 3])
        np.testing.assert_allclose(spot.axis, [0, -1, 0], atol=1e-6)
        self.assertEqual((spot.intensity, spot.inner_angle, spot.outer_angle), ((8, 0, 4), 0, 0.5))

    def test_refuses_what_it_does_not_convert(self):
        document = small_document()
        document["materials"][0]["doubleSided"] = True
        with self.assertRaises(InputError):
            read_scene(write_glb(document, self.binary))
        with self.assertRaises(InputError):
            read_scene("/dev/null")

    def test_refuses_a_broken_file_with_one_line(self):
        with self.assertRaises(InputError) as raised:
            read_scene(write_glb(small_document(), self.binary[:20]))
        self.assertNotIn("\n", str(raised.exception))
