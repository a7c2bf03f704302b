"""Meshes of a glTF file, in world space."""

import numpy as np

from scene import Material, Mesh


def read_meshes(gltf, node, to_world, materials):
    """Yields a Mesh for each primitive of a node, as often as the node is instanced."""
    if "skin" in node:
        gltf.refuse("a mesh has a skin, which is not converted")
    source = gltf.document["meshes"][node["mesh"]]
    weights = node.get("weights", source.get("weights"))
    for primitive in source["primitives"]:
        for instance_to_node in _instances(gltf, node):
            yield _mesh(gltf, primitive, weights, materials, to_world @ instance_to_node)


def _instances(gltf, node):
    """Transforms from a mesh to its node: one, or those of EXT_mesh_gpu_instancing."""
    extension = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
    if extension is None:
        return [np.eye(4)]
    given = {name: gltf.array(index).astype(float) for name, index in extension["attributes"].items()}
    count = max(len(values) for values in given.values())
    defaults = {"TRANSLATION": (0, 0, 0), "ROTATION": (0, 0, 0, 1), "SCALE": (1, 1, 1)}
    parts = [given.get(name, np.tile(missing, (count, 1))) for name, missing in defaults.items()]
    return [transform(*values) for values in zip(*parts, strict=True)]


def transform(translation, rotation, scale):
    """4 x 4, for column vectors; `rotation` is a quaternion x, y, z, w."""
    x, y, z, w = rotation
    turned = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turned * np.array(scale, float)
    matrix[:3, 3] = translation
    return matrix


def _mesh(gltf, primitive, weights, materials, to_world):
    if primitive.get("mode", 4) != 4:
        gltf.refuse("a mesh is not made of separate triangles, which is not converted")
    attributes = _attributes(gltf, primitive, weights)
    linear = to_world[:3, :3]
    position = attributes["POSITION"].astype(float) @ linear.T + to_world[:3, 3]
    triangles = np.arange(len(position), dtype=np.uint32)
    if "indices" in primitive:
        triangles = gltf.array(primitive["indices"]).astype(np.uint32)
    triangles = triangles.reshape(-1, 3)
    if triangles.size and triangles.max() >= len(position):
        gltf.refuse("a triangle has a corner that is not there")
    if np.linalg.det(linear) < 0:  # mirrored: counter-clockwise has become clockwise
        triangles = triangles[:, [0, 2, 1]]
    material = materials[primitive["material"]] if "material" in primitive else Material()
    return Mesh(
        material,
        position.astype(np.float32),
        triangles,
        _world_normal(attributes.get("NORMAL"), linear),
        tuple(attributes.get(f"TEXCOORD_{i}") for i in range(2)),
        _color(attributes.get("COLOR_0")),
    )


def _attributes(gltf, primitive, weights):
    """By name, with morph targets added as far as the file's weights have them."""
    attributes = {name: gltf.array(index) for name, index in primitive["attributes"].items()}
    for weight, target in zip(weights or [], primitive.get("targets", [])):
        for name, index in target.items():
            if weight != 0 and name in ("POSITION", "NORMAL"):
                attributes[name] = attributes[name].astype(float) + weight * gltf.array(index).astype(float)
    return attributes


def _world_normal(normal, linear):
    if normal is None or np.linalg.det(linear) == 0:
        return None
    turned = normal.astype(float) @ np.linalg.inv(linear)
    length = np.linalg.norm(turned, axis=1, keepdims=True)
    return (turned / np.where(length > 0, length, 1)).astype(np.float32)


def _color(color):
    """(vertices, 4)"""
    if color is None:
        return None
    opaque = np.ones((len(color), 4), np.float32)
    opaque[:, : color.shape[1]] = color
    return np.clip(opaque, 0, 1)
