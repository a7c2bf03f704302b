"""Materials and textures of a glTF file."""

import numpy as np

from scene import Material, TextureUse

_WRAP = {10497: "repeat", 33071: "clamp", 33648: "mirror"}



def read_materials(gltf):
    return [_material(gltf, source) for source in gltf.list_of("materials")]


def _material(gltf, source):
    pbr, extensions = source.get("pbrMetallicRoughness", {}), source.get("extensions", {})
    factor = tuple(float(c) for c in np.clip(pbr.get("baseColorFactor", (1, 1, 1, 1)), 0, 1))
    # Unlit surfaces show what was computed elsewhere: they are no lamps.
    is_unlit = "KHR_materials_unlit" in extensions
    strength = 0 if is_unlit else extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
    return Material(
        name=source.get("name", ""),
        kind="diffuse" if is_unlit else _kind(pbr, extensions),
        base_color=factor[:3],
        base_color_texture=_texture_use(gltf, pbr.get("baseColorTexture")),
        emitted_radiance=tuple(float(c) for c in np.array(source.get("emissiveFactor", (0, 0, 0)), float) * strength),
        emissive_texture=_texture_use(gltf, source.get("emissiveTexture")),
        index_of_refraction=extensions.get("KHR_materials_ior", {}).get("ior", 1.5),
        double_sided=source.get("doubleSided", False),
        alpha_mode=source.get("alphaMode", "OPAQUE"),
        alpha=factor[3],
        alpha_cutoff=source.get("alphaCutoff", 0.5),
    )


def _kind(pbr, extensions):
    is_smooth = "metallicRoughnessTexture" not in pbr and pbr.get("roughnessFactor", 1) <= 0.01
    if is_smooth and pbr.get("metallicFactor", 1) >= 0.99:
        return "mirror"
    if extensions.get("KHR_materials_transmission", {}).get("transmissionFactor", 0) < 0.5:
        return "diffuse"
    # Thickness says whether there is a body behind the surface; how thick it is, the mesh says itself.
    return "glass" if extensions.get("KHR_materials_volume", {}).get("thicknessFactor", 0) > 0 else "sheet"


def _texture_use(gltf, info):
    if info is None:
        return None
    texture = gltf.document["textures"][info["index"]]
    if "source" not in texture:
        gltf.refuse(f"textures/{info['index']} has no PNG or JPEG image")
    sampler = gltf.document["samplers"][texture["sampler"]] if "sampler" in texture else {}
    wrap = tuple(_WRAP[sampler.get(axis, 10497)] for axis in ("wrapS", "wrapT"))
    transform = info.get("extensions", {}).get("KHR_texture_transform")
    texcoord_set = (transform or {}).get("texCoord", info.get("texCoord", 0))
    return TextureUse(
        bytes(gltf.image(texture["source"])), texcoord_set, wrap, None if transform is None else _to_uv(transform)
    )


def _to_uv(transform):
    """Translation x rotation x scale, as the extension has it: its rotation turns from v to u."""
    u, v = transform.get("offset", (0, 0))
    cosine, sine = np.cos(transform.get("rotation", 0)), np.sin(transform.get("rotation", 0))
    translation = np.array([[1, 0, u], [0, 1, v], [0, 0, 1]], float)
    rotation = np.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]])
    matrix = translation @ rotation @ np.diag([*transform.get("scale", (1, 1)), 1])
    return tuple(tuple(float(x) for x in row) for row in matrix)
