"""The scene that a .glb file describes.

Read for the cross-check alone and sharing nothing with common/gltf, so that an error in either shows. What the
project's own scenes do not contain is refused rather than guessed.
"""

import struct

import numpy as np

from glb_file import GlbFile
from input_error import InputError
from scene import Material, Mesh, PointLight, Scene, SpotLight, TextureUse

_WRAP = {10497: "repeat", 33071: "clamp", 33648: "mirror"}
_KNOWN_EXTENSIONS = {
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_mesh_quantization",
}


def read_scene(file):
    """The scene of FILE (.glb). Raises InputError for what cannot be read or is not converted."""
    try:
        return _scene(GlbFile(file))
    except (KeyError, IndexError, TypeError, ValueError, struct.error) as error:
        raise InputError(f"{file}: broken: {error!r}") from error


def _scene(glb):
    for name in glb.list_of("extensionsUsed"):
        if name not in _KNOWN_EXTENSIONS:
            glb.refuse(f"uses the extension {name}, which is not converted")
    materials = [_material(glb, source) for source in glb.list_of("materials")]
    scene = Scene([], [], [])
    for node, to_world in _placed_nodes(glb):
        if "mesh" in node:
            for primitive in glb.document["meshes"][node["mesh"]]["primitives"]:
                scene.meshes.append(_mesh(glb, primitive, materials, to_world))
        light = node.get("extensions", {}).get("KHR_lights_punctual")
        if light is not None:
            _append_light(glb, light["light"], to_world, scene)
    return scene


def _placed_nodes(glb):
    """Every node of the scene with its transform, a 4 x 4 matrix for column vectors."""
    nodes = glb.list_of("nodes")
    pending = [(index, np.eye(4)) for index in glb.document["scenes"][glb.document.get("scene", 0)]["nodes"]]
    while pending:
        index, parent = pending.pop()
        to_world = parent @ _local_transform(nodes[index])
        yield nodes[index], to_world
        pending += [(child, to_world) for child in nodes[index].get("children", [])]


def _local_transform(node):
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    x, y, z, w = np.array(node.get("rotation", (0, 0, 0, 1)), float)
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = rotation * np.array(node.get("scale", (1, 1, 1)), float)
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def _mesh(glb, primitive, materials, to_world):
    if primitive.get("mode", 4) != 4:
        glb.refuse("a mesh is not made of separate triangles, which is not converted")
    attributes = {name: glb.array(index) for name, index in primitive["attributes"].items()}
    linear = to_world[:3, :3]
    position = attributes["POSITION"].astype(float) @ linear.T + to_world[:3, 3]
    triangles = np.arange(len(position), dtype=np.uint32)
    if "indices" in primitive:
        triangles = glb.array(primitive["indices"]).astype(np.uint32)
    triangles = triangles.reshape(-1, 3)
    if np.linalg.det(linear) < 0:  # mirrored: counter-clockwise has become clockwise
        triangles = triangles[:, [0, 2, 1]]
    normal = None
    if "NORMAL" in attributes:
        normal = attributes["NORMAL"].astype(float) @ np.linalg.inv(linear)
        normal = (normal / np.linalg.norm(normal, axis=1, keepdims=True)).astype(np.float32)
    material = materials[primitive["material"]] if "material" in primitive else Material()
    texcoord = tuple(attributes.get(f"TEXCOORD_{i}") for i in range(2))
    return Mesh(material, position.astype(np.float32), triangles, normal, texcoord)


def _texture_use(glb, info):
    if info is None:
        return None
    if "extensions" in info:
        glb.refuse("a texture has extensions, which are not converted")
    texture = glb.document["textures"][info["index"]]
    sampler = glb.document["samplers"][texture["sampler"]] if "sampler" in texture else {}
    wrap_u, wrap_v = sampler.get("wrapS", 10497), sampler.get("wrapT", 10497)
    if wrap_u != wrap_v:
        glb.refuse("a texture wraps differently in u and v, which is not converted")
    return TextureUse(glb.image(texture["source"]), info.get("texCoord", 0), _WRAP[wrap_u])


def _kind(pbr, extensions):
    is_smooth = "metallicRoughnessTexture" not in pbr and pbr.get("roughnessFactor", 1) <= 0.01
    if is_smooth and pbr.get("metallicFactor", 1) >= 0.99:
        return "mirror"
    transmission = extensions.get("KHR_materials_transmission", {}).get("transmissionFactor", 0)
    return "glass" if transmission >= 0.5 else "diffuse"


def _material(glb, source):
    pbr, extensions = source.get("pbrMetallicRoughness", {}), source.get("extensions", {})
    strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
    material = Material(
        source.get("name", ""),
        _kind(pbr, extensions),
        tuple(np.clip(pbr.get("baseColorFactor", (1, 1, 1, 1))[:3], 0, 1)),
        _texture_use(glb, pbr.get("baseColorTexture")),
        tuple(np.array(source.get("emissiveFactor", (0, 0, 0)), float) * strength),
        _texture_use(glb, source.get("emissiveTexture")),
        extensions.get("KHR_materials_ior", {}).get("ior", 1.5),
    )
    if material.emits and source.get("doubleSided", False):
        glb.refuse(f"material '{material.name}' emits from both faces, which is not converted")
    return material


def _append_light(glb, index, to_world, scene):
    light = glb.document["extensions"]["KHR_lights_punctual"]["lights"][index]
    intensity = tuple(np.array(light.get("color", (1, 1, 1)), float) * light.get("intensity", 1))
    position = tuple(to_world[:3, 3])
    if light["type"] == "point":
        scene.point_lights.append(PointLight(position, intensity))
    elif light["type"] == "spot":
        axis = -to_world[:3, 2] / np.linalg.norm(to_world[:3, 2])
        cone = light.get("spot", {})
        inner, outer = cone.get("innerConeAngle", 0), cone.get("outerConeAngle", np.pi / 4)
        scene.spot_lights.append(SpotLight(position, tuple(axis), intensity, inner, outer))
    else:
        glb.refuse(f"lights/{index} is of the type '{light['type']}', which is not converted")
