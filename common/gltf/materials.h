// glTF materials -> diffuse surfaces, mirrors and glass.
#pragma once

#include <tiny_gltf.h>

#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Sets scene.material and scene.texture: the model's materials in their order, and behind them glTF's
/// default material for primitives that name none.
///
/// metallicFactor >= 0.99 with roughnessFactor <= 0.01 and no metallicRoughnessTexture is a mirror.
/// transmissionFactor, less its metallic part, >= 0.5 is a dielectric where KHR_materials_volume gives it a
/// thickness, else a thin sheet. Everything else is diffuse with the base colour, or the diffuse colour of
/// KHR_materials_pbrSpecularGlossiness, as albedo. KHR_materials_unlit is diffuse and does not emit. Throws
/// InputError for an image that a material needs and that cannot be read.
void append_materials(const tinygltf::Model& model, Scene& scene, Warnings& warnings);

/// Index into scene.material of a primitive's material (-1: none).
[[nodiscard]] std::uint32_t material_index(const Scene& scene, int material);

}  // namespace common::gltf
