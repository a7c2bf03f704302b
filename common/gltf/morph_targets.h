// Morph targets without animation: glTF 2.0, section 3.7.2.2.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <string>

#include "common/gltf/primitive.h"
#include "common/gltf/warnings.h"

namespace common::gltf {

/// Returns the weights of a node's mesh without animation: the node's own, else the mesh's, else none.
[[nodiscard]] std::span<const double> rest_weights(const tinygltf::Mesh& mesh, const tinygltf::Node& node);

/// Adds the primitive's targets times their weights to `attributes`, which belong to the vertices `vertices`.
/// Targets without a weight are ignored. Warns, naming the mesh `name`, of colours, which are not morphed.
/// Throws InputError for targets of a wrong type or length.
void morph(AccessorReader& accessors, const tinygltf::Primitive& primitive, std::span<const double> weights,
           std::span<const std::uint32_t> vertices, Attributes& attributes, const std::string& name,
           Warnings& warnings);

}  // namespace common::gltf
