// What one mesh primitive holds, in the space of its node.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vector.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Vertex attributes. Each list has one entry per vertex, or none where the file does not have it.
struct Attributes {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    std::vector<Vec3> tangent;
    std::vector<float> tangent_sign;
    std::array<std::vector<Vec2>, 2> texcoord;
};

/// True for the modes TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN.
[[nodiscard]] bool is_made_of_triangles(const tinygltf::Primitive& primitive);

/// Throws InputError for a wrong attribute type and for attributes of different length.
[[nodiscard]] Attributes read_attributes(const tinygltf::Model& model, const tinygltf::Primitive& primitive);

/// The triangles of a primitive with `vertex_count` vertices, listed or counted off, out of a list, strip or
/// fan; vertices that are left over make none. Throws InputError for an index beyond the vertices.
[[nodiscard]] std::vector<TriangleVertices> read_triangles(const tinygltf::Model& model,
                                                           const tinygltf::Primitive& primitive,
                                                           std::uint32_t vertex_count);

}  // namespace common::gltf
