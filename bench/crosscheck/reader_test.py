"""Are .gltf and .glb files read as glTF 2.0 and its extensions say?"""

import base64
import json
import struct
import tempfile
import unittest
from pathlib import Path

import numpy as np

from gltf_scene import read_scene
from input_error import InputError
from test_scenes import unit


def write_glb(document, binary):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += bytes(-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    file = Path(tempfile.mkdtemp()) / "scene.glb"
    file.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return file


def write_gltf(document):
    file = Path(tempfile.mkdtemp()) / "scene.gltf"
    file.write_text(json.dumps(document), encoding="utf-8")
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


TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)


class Document:
    """A triangle, to which a test adds what it is about."""

    def __init__(self):
        self.json = {
            "asset": {"version": "2.0"},
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "accessors": [],
            "bufferViews": [],
        }
        self.binary = b""
        self.attributes = {"POSITION": self.accessor(TRIANGLE)}
        self.json["meshes"] = [{"primitives": [{"attributes": self.attributes}]}]

    def view(self, values):
        data = np.ascontiguousarray(values).tobytes()
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data + bytes(-len(data) % 4)
        return len(self.json["bufferViews"]) - 1

    def accessor(self, values, **more):
        component = {"float32": 5126, "uint8": 5121, "uint16": 5123}[values.dtype.name]
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}[values.shape[1]]
        self.json["accessors"].append(
            {"bufferView": self.view(values), "componentType": component, "type": kind, "count": len(values), **more}
        )
        return len(self.json["accessors"]) - 1

    def material(self, **source):
        self.json["materials"] = [source]
        self.json["meshes"][0]["primitives"][0]["material"] = 0

    def read(self):
        return read_scene(write_glb({**self.json, "buffers": [{"byteLength": len(self.binary)}]}, self.binary))


class Reader(unittest.TestCase):
    binary = TRIANGLE.tobytes()

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

    def test_buffers_in_data_uris_and_in_files_of_their_own(self):
        document = small_document()
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
        inside = read_scene(write_gltf(document)).meshes[0]
        document["buffers"][0]["uri"] = "a%20buffer.bin"
        file = write_gltf(document)
        (file.parent / "a buffer.bin").write_bytes(self.binary)
        beside = read_scene(file).meshes[0]
        expected = read_scene(write_glb(small_document(), self.binary)).meshes[0]
        np.testing.assert_array_equal(inside.position, expected.position)
        np.testing.assert_array_equal(beside.position, expected.position)

    def test_refuses_what_it_does_not_convert(self):
        document = small_document()
        for change in (
            {"extensionsUsed": ["KHR_draco_mesh_compression"]},
            {"extensionsUsed": ["KHR_materials_clearcoat"], "extensionsRequired": ["KHR_materials_clearcoat"]},
            {"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}]},
            {"nodes": [{"children": [0]}]},
        ):
            with self.assertRaises(InputError, msg=str(change)):
                read_scene(write_glb({**document, **change}, self.binary))
        with self.assertRaises(InputError):
            read_scene("/dev/null")

    def test_refuses_a_broken_file_with_one_line(self):
        missing, bad_uri = small_document(), small_document()
        missing["buffers"][0]["uri"] = "not-there.bin"
        bad_uri["buffers"][0]["uri"] = "data:;base64,!!!"
        for file in (write_glb(small_document(), self.binary[:20]), write_gltf(missing), write_gltf(bad_uri), write_gltf([1])):
            with self.assertRaises(InputError) as raised:
                read_scene(file)
            self.assertNotIn("\n", str(raised.exception))


class Attributes(unittest.TestCase):
    def test_vertex_colours_of_all_kinds(self):
        bytes_of = np.array([[255, 0, 128, 51]] * 3, np.uint8)
        for values, expected in (
            (np.array([[0.25, 0.5, 2]] * 3, np.float32), (0.25, 0.5, 1, 1)),
            (bytes_of, (1, 0, 128 / 255, 0.2)),
            (257 * bytes_of.astype(np.uint16), (1, 0, 128 / 255, 0.2)),
        ):
            document = Document()
            document.attributes["COLOR_0"] = document.accessor(values, normalized=values.dtype != np.float32)
            np.testing.assert_allclose(document.read().meshes[0].color, [expected] * 3, atol=1e-6)

    def test_sparse_values_and_morph_targets(self):
        document = Document()
        index, value = document.view(np.array([1], np.uint16)), document.view(np.array([[0, 0, 5]], np.float32))
        sparse = {"indices": {"bufferView": index, "componentType": 5123}, "values": {"bufferView": value}, "count": 1}
        document.json["accessors"].append({"componentType": 5126, "type": "VEC3", "count": 3, "sparse": sparse})
        target = len(document.json["accessors"]) - 1
        document.json["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": target}]
        document.json["meshes"][0]["weights"] = [0.5]
        np.testing.assert_allclose(document.read().meshes[0].position, [[0, 0, 0], [1, 0, 2.5], [0, 1, 0]])

    def test_a_triangle_without_its_corners_is_refused(self):
        document = Document()
        document.json["meshes"][0]["primitives"][0]["indices"] = document.accessor(np.array([[0], [1], [3]], np.uint8))
        with self.assertRaises(InputError):
            document.read()


class Extensions(unittest.TestCase):
    def test_instances(self):
        document = Document()
        document.json["extensionsUsed"] = ["EXT_mesh_gpu_instancing"]
        moves = document.accessor(np.array([[0, 0, 0], [0, 0, 4]], np.float32))
        sizes = document.accessor(np.array([[1, 1, 1], [3, 1, 1]], np.float32))
        instancing = {"attributes": {"TRANSLATION": moves, "SCALE": sizes}}
        document.json["nodes"] = [
            {"mesh": 0, "translation": [10, 0, 0], "extensions": {"EXT_mesh_gpu_instancing": instancing}}
        ]
        first, second = document.read().meshes
        np.testing.assert_allclose(first.position, TRIANGLE + [10, 0, 0])
        np.testing.assert_allclose(second.position, TRIANGLE * [3, 1, 1] + [10, 0, 4])

    def test_where_textures_are_read(self):
        document = Document()
        document.json["images"] = [{"uri": "data:image/png;base64,AAAA"}]
        document.json["samplers"] = [{"wrapS": 33071}]
        document.json["textures"] = [{"source": 0, "sampler": 0}]
        moved = {"offset": [0.5, 0.25], "rotation": np.pi / 2, "scale": [2, 3], "texCoord": 1}
        info = {"index": 0, "texCoord": 0, "extensions": {"KHR_texture_transform": moved}}
        document.material(pbrMetallicRoughness={"baseColorTexture": info})
        use = document.read().meshes[0].material.base_color_texture
        self.assertEqual((use.image, use.texcoord_set, use.wrap), (b"\0\0\0", 1, ("clamp", "repeat")))
        # Scaled to (2, 0) and (0, 3), turned by a quarter from v to u, as v points down, and moved.
        for texcoord, expected in (((1, 0), (0.5, 0.25 - 2)), ((0, 1), (0.5 + 3, 0.25))):
            np.testing.assert_allclose((np.array(use.to_uv) @ [*texcoord, 1])[:2], expected, atol=1e-12)

    def test_kinds_of_glass(self):
        for volume, expected in (({}, "sheet"), ({"KHR_materials_volume": {}}, "sheet"), ({"KHR_materials_volume": {"thicknessFactor": 1}}, "glass")):
            document = Document()
            document.material(extensions={"KHR_materials_transmission": {"transmissionFactor": 1}, **volume})
            self.assertEqual(document.read().meshes[0].material.kind, expected)

    def test_alpha_and_faces(self):
        document = Document()
        document.material(doubleSided=True, alphaMode="MASK", pbrMetallicRoughness={"baseColorFactor": [1, 1, 1, 0.25]})
        material = document.read().meshes[0].material
        self.assertEqual((material.double_sided, material.alpha_mode, material.alpha, material.alpha_cutoff), (True, "MASK", 0.25, 0.5))

    def test_unlit_surfaces_are_no_lamps(self):
        document = Document()
        document.material(emissiveFactor=[1, 1, 1], extensions={"KHR_materials_unlit": {}})
        self.assertFalse(document.read().meshes[0].material.emits)

    def test_directional_lights(self):
        document = Document()
        document.json["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 3, "range": 9}]}}
        document.json["nodes"].append({"scale": [2, 2, 2], "extensions": {"KHR_lights_punctual": {"light": 0}}})
        document.json["scenes"][0]["nodes"].append(1)
        scene = document.read()
        np.testing.assert_allclose(scene.directional_lights[0].direction, (0, 0, -1))
        self.assertEqual(scene.directional_lights[0].irradiance, (3, 3, 3))
        self.assertEqual(scene.left_out, ["the range of lights/0"])

    def test_what_only_changes_looks_is_left_out_and_said(self):
        document = Document()
        document.json["extensionsUsed"] = ["KHR_materials_clearcoat"]
        self.assertEqual(document.read().left_out, ["KHR_materials_clearcoat"])
