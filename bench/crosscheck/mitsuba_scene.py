"""A Scene handed to Mitsuba. A variant must be set before this module is imported."""

import mitsuba as mi
import numpy as np

from input_error import InputError

# The falloff of a spot is tabulated over the square round its cone; see README.md for the error.
_FALLOFF_SIZE = 2048


def mitsuba_scene(scene):
    """mi.Scene with the model of common/tracer: diffuse surfaces reflect on both faces round their geometric normal,
    mirrors and glass follow the vertex normals, emitters shine from the front face."""
    described = {"type": "scene"}
    bsdfs = {id(mesh.material): _bsdf(mesh.material) for mesh in scene.meshes}
    for i, mesh in enumerate(scene.meshes):
        described[f"mesh{i}"] = _shape(f"mesh{i}", mesh, bsdfs[id(mesh.material)])
    for i, light in enumerate(scene.point_lights):
        described[f"point{i}"] = {
            "type": "point",
            "position": list(light.position),
            "intensity": _spectrum(light.intensity),
        }
    for i, light in enumerate(scene.spot_lights):
        described[f"spot{i}"] = _spot(light)
    return mi.load_dict(described)


def linear_of_srgb(encoded):
    """IEC 61966-2-1, for values in [0, 1]."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def spot_falloff(cos_angle, light):
    """Share of the axial intensity: the square of a linear ramp in the cosine (KHR_lights_punctual)."""
    inner, outer = np.cos(light.inner_angle), np.cos(light.outer_angle)
    return np.clip((cos_angle - outer) / max(inner - outer, 1e-6), 0, 1) ** 2


def _spectrum(rgb):
    return {"type": "rgb", "value": [float(c) for c in rgb]}


def _texture(factor, use):
    if use is None:
        return _spectrum(factor)
    stream = mi.MemoryStream()
    stream.write(use.image)
    stream.seek(0)
    image = mi.Bitmap(stream).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, srgb_gamma=True)
    texels = linear_of_srgb(np.array(image) / 255.0) * np.array(factor)
    return _bitmap(texels, use.wrap)


def _bitmap(texels, wrap):
    return {
        "type": "bitmap",
        "data": mi.TensorXf(texels.astype(np.float32)),
        "raw": True,
        "format": "variant",
        "filter_type": "bilinear",
        "wrap_mode": wrap,
    }


def _bsdf(material):
    color = _texture(material.base_color, material.base_color_texture)
    if material.kind == "diffuse":
        return mi.load_dict({"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": color}})
    if material.kind == "mirror":
        conductor = {"type": "conductor", "material": "none", "specular_reflectance": color}
        return mi.load_dict({"type": "twosided", "bsdf": conductor})
    return mi.load_dict(
        {
            "type": "dielectric",
            "int_ior": float(material.index_of_refraction),
            "ext_ior": 1.0,
            "specular_reflectance": color,
            "specular_transmittance": color,
        }
    )


def _texcoord(mesh):
    """The coordinates that the material's textures read."""
    material = mesh.material
    used = {use.texcoord_set for use in (material.base_color_texture, material.emissive_texture) if use}
    if len(used) > 1:
        raise InputError(f"material '{material.name}' reads two sets of texture coordinates")
    return mesh.texcoord[used.pop()] if used else None


def _shape(name, mesh, bsdf):
    # Without vertex normals Mitsuba shades with the triangle's own, as the tracer does on diffuse surfaces.
    normal = mesh.normal if mesh.material.kind != "diffuse" else None
    texcoord = _texcoord(mesh)
    properties = mi.Properties()
    properties["bsdf"] = bsdf
    if mesh.material.emits:
        radiance = _texture(mesh.material.emitted_radiance, mesh.material.emissive_texture)
        properties["emitter"] = mi.load_dict({"type": "area", "radiance": radiance})
    shape = mi.Mesh(
        name,
        len(mesh.position),
        len(mesh.triangles),
        properties,
        has_vertex_normals=normal is not None,
        has_vertex_texcoords=texcoord is not None,
    )
    parameters = mi.traverse(shape)
    parameters["vertex_positions"] = mesh.position.ravel()
    parameters["faces"] = mesh.triangles.ravel()
    if normal is not None:
        parameters["vertex_normals"] = normal.ravel()
    if texcoord is not None:
        parameters["vertex_texcoords"] = texcoord.astype(np.float32).ravel()
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
