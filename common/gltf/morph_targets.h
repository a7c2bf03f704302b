// Morph targets at rest: glTF 2.0, section 3.7.2.2.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <string>

#include "common/gltf/primitive.h"
#include "common/gltf/warnings.h"

namespace common::gltf {

/// The weights of a node's mesh where no animation plays: the node's own, else the mesh's, else none.
[[nodiscard]] std::span<const double> rest_weights(const tinygltf::Mesh& mesh, const tinygltf::Node& node);

/// Adds to `attributes`, those of the vertices `vertices`, the primitive's targets times their weights. What
/// is not given a weight has none. Warns, about the mesh `name`, of colours that are not moved. Throws
/// InputError for targets of a wrong type or length.
void morph(AccessorReader& accessors, const tinygltf::Primitive& primitive, std::span<const double> weights,
           std::span<const std::uint32_t> vertices, Attributes& attributes, const std::string& name,
           Warnings& warnings);

}  // namespace common::gltf
