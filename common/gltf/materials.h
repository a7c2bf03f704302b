// Converts glTF materials to diffuse surfaces, mirrors and glass.
#pragma once

#include <tiny_gltf.h>

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Sets scene.material and scene.texture: the model's materials in their order, followed by glTF's default
/// material for primitives without one.
///
/// A material with metallicFactor >= 0.99, roughnessFactor <= 0.01 and no metallicRoughnessTexture becomes a
/// mirror. One whose transmissionFactor, less its metallic part, is >= 0.5 becomes a dielectric if
/// KHR_materials_volume gives it a thickness, else a thin sheet. Every other one becomes diffuse. Its albedo
/// is the base colour, or the diffuse colour of KHR_materials_pbrSpecularGlossiness. KHR_materials_unlit
/// becomes diffuse without emission. Throws InputError if an image that a material needs cannot be read.
void append_materials(const tinygltf::Model& model, Scene& scene, Warnings& warnings);

/// Returns the index into scene.material of a primitive's material (-1: none).
[[nodiscard]] std::uint32_t material_index(const Scene& scene, int material);

}  // namespace common::gltf
