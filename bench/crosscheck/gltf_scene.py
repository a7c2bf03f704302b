"""The scene that a glTF file describes.

Read for the cross-check alone and sharing nothing with common/gltf, so that an error in either shows. What would
move surfaces or light and is not converted is refused rather than guessed.
"""

import struct

import numpy as np

from gltf_file import GltfFile
from gltf_material import read_materials
from gltf_mesh import read_meshes, transform
from input_error import InputError
from scene import DirectionalLight, PointLight, Scene, SpotLight

_CONVERTED = {
    "EXT_mesh_gpu_instancing",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
}
# Without these a scene is another one, whatever the file says of needing them.
_REFUSED = {
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_materials_pbrSpecularGlossiness",
}


def read_scene(file):
    """The scene of FILE (.gltf or .glb). Raises InputError for what cannot be read or is not converted."""
    try:
        return _scene(GltfFile(file))
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, struct.error) as error:
        raise InputError(f"{file}: broken: {error!r}") from error


def _scene(gltf):
    scene = Scene([], left_out=_left_out(gltf))
    materials = read_materials(gltf)
    for node, to_world in _placed_nodes(gltf):
        if "mesh" in node:
            scene.meshes.extend(read_meshes(gltf, node, to_world, materials))
        light = node.get("extensions", {}).get("KHR_lights_punctual")
        if light is not None:
            _append_light(gltf, light["light"], to_world, scene)
    return scene


def _left_out(gltf):
    """Extensions that only change how a surface looks: what they ask for is drawn without them, by both."""
    required = set(gltf.list_of("extensionsRequired"))
    left_out = [name for name in gltf.list_of("extensionsUsed") if name not in _CONVERTED]
    for name in [*left_out, *required]:
        if name in _REFUSED or (name in required and name not in _CONVERTED):
            gltf.refuse(f"uses the extension {name}, which is not converted")
    return left_out


def _placed_nodes(gltf):
    """Every node of the scene with its transform, a 4 x 4 matrix for column vectors."""
    nodes = gltf.list_of("nodes")
    pending = [(index, np.eye(4)) for index in gltf.document["scenes"][gltf.document.get("scene", 0)]["nodes"]]
    for _ in nodes:  # each has at most one parent
        if not pending:
            return
        index, parent = pending.pop()
        to_world = parent @ _local_transform(nodes[index])
        yield nodes[index], to_world
        pending += [(child, to_world) for child in nodes[index].get("children", [])]
    if pending:
        gltf.refuse("its nodes are no trees")


def _local_transform(node):
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    return transform(node.get("translation", (0, 0, 0)), node.get("rotation", (0, 0, 0, 1)), node.get("scale", (1, 1, 1)))


def _append_light(gltf, index, to_world, scene):
    light = gltf.document["extensions"]["KHR_lights_punctual"]["lights"][index]
    strength = tuple(float(c) for c in np.array(light.get("color", (1, 1, 1)), float) * light.get("intensity", 1))
    if light.get("range", 0) > 0:
        scene.left_out.append(f"the range of lights/{index}")
    position, along = tuple(to_world[:3, 3]), -to_world[:3, 2] / np.linalg.norm(to_world[:3, 2])
    if light["type"] == "point":
        scene.point_lights.append(PointLight(position, strength))
    elif light["type"] == "spot":
        cone = light.get("spot", {})
        outer = cone.get("outerConeAngle", np.pi / 4)
        scene.spot_lights.append(SpotLight(position, tuple(along), strength, cone.get("innerConeAngle", 0), outer))
    elif light["type"] == "directional":
        scene.directional_lights.append(DirectionalLight(tuple(along), strength))
    else:
        gltf.refuse(f"lights/{index} is of the type '{light['type']}', which is not converted")
