"""A Scene handed to Mitsuba. A variant must be set before this module is imported."""

import mitsuba as mi
import numpy as np

import both_faces_emitter  # noqa: F401  registers itself
import mitsuba_textures  # noqa: F401  registers themselves
from images import linear_texels
from input_error import InputError

# The falloff of a spot is tabulated over the square round its cone; see README.md for the error.
_FALLOFF_SIZE = 2048
_VERTEX_COLOR, _VERTEX_ALPHA = "vertex_color", "vertex_alpha"


def mitsuba_scene(scene):
    """mi.Scene with the model of common/tracer: diffuse surfaces reflect on both faces round their geometric normal,
    mirrors and glass follow the vertex normals, emitters shine from the front face or, double-sided, from both."""
    described = {"type": "scene"}
    bsdfs = {}
    for i, mesh in enumerate(scene.meshes):
        if len(mesh.triangles) == 0:
            continue
        key = id(mesh.material), mesh.color is None
        if key not in bsdfs:
            bsdfs[key] = _bsdf(mesh)
        described[f"mesh{i}"] = _shape(f"mesh{i}", mesh, bsdfs[key])
    for i, light in enumerate(scene.point_lights):
        described[f"point{i}"] = {
            "type": "point",
            "position": list(light.position),
            "intensity": _spectrum(light.intensity),
        }
    for i, light in enumerate(scene.spot_lights):
        described[f"spot{i}"] = _spot(light)
    for i, light in enumerate(scene.directional_lights):
        described[f"directional{i}"] = {
            "type": "directional",
            "direction": list(light.direction),
            "irradiance": _spectrum(light.irradiance),
        }
    if max(scene.sky_radiance) > 0:
        described["sky"] = {"type": "constant", "radiance": _spectrum(scene.sky_radiance)}
    return mi.load_dict(described)


def lets_light_through(scene):
    """Whether anything in it lets light pass as it comes: holes, or glass without thickness."""
    return any(mesh.material.kind == "sheet" or _has_holes(mesh) for mesh in scene.meshes)


def spot_falloff(cos_angle, light):
    """Share of the axial intensity: the square of a linear ramp in the cosine (KHR_lights_punctual)."""
    inner, outer = np.cos(light.inner_angle), np.cos(light.outer_angle)
    if inner <= outer:
        return np.where(cos_angle >= outer, 1.0, 0.0)
    return np.clip((cos_angle - outer) / (inner - outer), 0, 1) ** 2


def _spectrum(rgb):
    return {"type": "rgb", "value": [float(c) for c in rgb]}


# Textures, as dictionaries that Mitsuba makes objects of.


def _bitmap(texels, wrap, to_uv=None):
    bitmap = {
        "type": "bitmap",
        "data": mi.TensorXf(texels.astype(np.float32)),
        "raw": True,
        "format": "variant",
        "filter_type": "bilinear",
        "wrap_mode": wrap,
    }
    return bitmap if to_uv is None else {**bitmap, "to_uv": mi.ScalarTransform3f(np.array(to_uv))}


def _image(use, channels, factor):
    texels = linear_texels(use.image)[..., channels] * np.array(factor, float)
    if use.wrap[0] == use.wrap[1]:
        return _bitmap(texels, use.wrap[0], use.to_uv)
    (height, width), matrix = texels.shape[:2], np.eye(3) if use.to_uv is None else np.array(use.to_uv)
    return {
        "type": "gltf_wrapped",
        "of": _bitmap(texels, "repeat"),
        **{f"uv{i}": float(x) for i, x in enumerate(matrix[:2].ravel())},
        **{f"wrap_{axis}": wrap for axis, wrap in zip("uv", use.wrap)},
        "margin_u": 0.5 / width,
        "margin_v": 0.5 / height,
    }


def _product(textures):
    product, *rest = textures
    for texture in rest:
        product = {"type": "gltf_product", "first": product, "second": texture}
    return product


def _base_color(mesh):
    """What the vertices have includes the factor."""
    material, use = mesh.material, mesh.material.base_color_texture
    textures = [] if mesh.color is None else [{"type": "mesh_attribute", "name": _VERTEX_COLOR}]
    if use:
        textures.append(_image(use, slice(0, 3), material.base_color if mesh.color is None else (1, 1, 1)))
    return _product(textures) if textures else _spectrum(material.base_color)


def _coverage(mesh):
    """How much of the surface is there, from 0 to 1; None where all of it is."""
    if not _has_holes(mesh):
        return None
    material, use = mesh.material, mesh.material.base_color_texture
    textures = [] if mesh.color is None else [{"type": "mesh_attribute", "name": _VERTEX_ALPHA}]
    if use:
        textures.append(_image(use, slice(3, 4), material.alpha if mesh.color is None else 1))
    alpha = _product(textures) if textures else {"type": "uniform", "value": float(material.alpha)}
    if material.alpha_mode == "BLEND":
        return alpha
    return {"type": "gltf_covered", "of": alpha, "cutoff": float(material.alpha_cutoff)}


def _has_holes(mesh):
    material, use = mesh.material, mesh.material.base_color_texture
    if material.alpha_mode == "OPAQUE":
        return False
    least = material.alpha * (1 if mesh.color is None else mesh.color[:, 3].min())
    if use:
        least *= linear_texels(use.image)[..., 3].min()
    return least < (1 if material.alpha_mode == "BLEND" else material.alpha_cutoff)


# Surfaces.


def _bsdf(mesh):
    bsdf, coverage = _solid_bsdf(mesh), _coverage(mesh)
    return mi.load_dict(bsdf if coverage is None else {"type": "mask", "opacity": coverage, "bsdf": bsdf})


def _solid_bsdf(mesh):
    color, index = _base_color(mesh), float(mesh.material.index_of_refraction)
    if mesh.material.kind == "diffuse":
        return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": color}}
    if mesh.material.kind == "mirror":
        return {"type": "twosided", "bsdf": {"type": "conductor", "material": "none", "specular_reflectance": color}}
    if index < 1:
        raise InputError(f"material '{mesh.material.name}' has an index of refraction below 1, which is not converted")
    return {
        "type": "dielectric" if mesh.material.kind == "glass" else "thindielectric",
        "int_ior": index,
        "ext_ior": 1.0,
        "specular_reflectance": color,
        "specular_transmittance": _base_color(mesh),  # a second one: an image's numbers are handed over, not copied
    }


def _texcoord(mesh):
    """The coordinates that the material's textures read; zeros where the mesh lacks them."""
    material = mesh.material
    used = {use.texcoord_set for use in (material.base_color_texture, material.emissive_texture) if use}
    if len(used) > 1:
        raise InputError(f"material '{material.name}' reads two sets of texture coordinates, which is not converted")
    if not used:
        return None
    given = dict(enumerate(mesh.texcoord)).get(used.pop())
    return np.zeros((len(mesh.position), 2), np.float32) if given is None else given.astype(np.float32)


def _emitter(mesh):
    material, coverage = mesh.material, _coverage(mesh)
    radiance = _spectrum(material.emitted_radiance)
    if material.emissive_texture:
        radiance = _image(material.emissive_texture, slice(0, 3), material.emitted_radiance)
    if coverage is not None:
        if mesh.color is not None:
            raise InputError(f"material '{material.name}' emits through alpha of vertices, which is not converted")
        radiance = _product([radiance, coverage])
    if radiance["type"] != "rgb":
        radiance = {"type": "gltf_emitted", "of": radiance}
    return mi.load_dict({"type": "gltf_both_faces" if material.double_sided else "area", "radiance": radiance})


def _shape(name, mesh, bsdf):
    # Without vertex normals Mitsuba shades with the triangle's own, as the tracer does on diffuse surfaces.
    normal = mesh.normal if mesh.material.kind != "diffuse" else None
    texcoord = _texcoord(mesh)
    properties = mi.Properties()
    properties["bsdf"] = bsdf
    if mesh.material.emits:
        properties["emitter"] = _emitter(mesh)
    shape = mi.Mesh(
        name,
        len(mesh.position),
        len(mesh.triangles),
        properties,
        has_vertex_normals=normal is not None,
        has_vertex_texcoords=texcoord is not None,
    )
    if mesh.color is not None:
        factor = np.array([*mesh.material.base_color, mesh.material.alpha])
        color = (mesh.color * factor).astype(np.float32)
        shape.add_attribute(_VERTEX_COLOR, 3, color[:, :3].ravel())
        shape.add_attribute(_VERTEX_ALPHA, 1, color[:, 3].ravel())
    parameters = mi.traverse(shape)
    parameters["vertex_positions"] = mesh.position.ravel()
    parameters["faces"] = mesh.triangles.ravel()
    if normal is not None:
        parameters["vertex_normals"] = normal.ravel()
    if texcoord is not None:
        parameters["vertex_texcoords"] = texcoord.ravel()
    parameters.update()
    return shape


def _spot(light):
    """Mitsuba's own falloff is linear in the angle; this one is a texture over the cone."""
    if light.outer_angle > np.radians(85):
        raise InputError("a spot's outer angle beyond 85 degrees is not converted")
    edge = np.tan(light.outer_angle)
    across = ((np.arange(_FALLOFF_SIZE) + 0.5) / _FALLOFF_SIZE * 2 - 1) * edge
    cos_angle = 1 / np.sqrt(1 + across[:, None] ** 2 + across[None, :] ** 2)
    falloff = spot_falloff(cos_angle, light)[..., None] * np.ones(3)
    position = np.array(light.position, float)
    up = np.eye(3)[np.argmin(np.abs(light.axis))]
    degrees = float(np.degrees(light.outer_angle))
    return {
        "type": "spot",
        "to_world": mi.ScalarTransform4f().look_at(
            list(position), list(position + np.array(light.axis)), list(up)
        ),
        "intensity": _spectrum(light.intensity),
        "cutoff_angle": degrees,
        # As wide as the cone, so that the texture alone says how the light falls off.
        "beam_width": degrees * (1 - 1e-6),
        "texture": _bitmap(falloff, "clamp"),
    }
