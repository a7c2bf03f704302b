// The contents of one mesh primitive, in the space of its node.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vector.h"
#include "common/gltf/accessor.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Vertex attributes. Each list has one entry per vertex, or none if the file does not have the attribute.
struct Attributes {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    std::vector<Vec3> tangent;
    std::vector<float> tangent_sign;
    std::array<std::vector<Vec2>, 2> texcoord;
};

/// The triangles of a primitive and only the vertices that they use, as many primitives can share the vertex
/// lists of a whole file.
struct PrimitiveTriangles {
    std::vector<TriangleVertices> triangle;  ///< corners as indices into `vertex`
    std::vector<std::uint32_t> vertex;       ///< indices of the primitive's attributes, in order of first use
};

/// Returns true for the modes TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN.
[[nodiscard]] bool is_made_of_triangles(const tinygltf::Primitive& primitive);

/// Reads the triangles of the primitives of a model.
class TriangleReader {
  public:
    explicit TriangleReader(AccessorReader& accessors) : accessors_(accessors) {}

    /// Returns the triangles of a list, strip or fan, with or without indices. Leftover vertices form none.
    /// Throws InputError for an index beyond the vertices.
    [[nodiscard]] PrimitiveTriangles read(const tinygltf::Primitive& primitive);

  private:
    [[nodiscard]] std::vector<std::uint32_t> number_vertices(std::span<TriangleVertices> triangles,
                                                             std::uint32_t vertex_count);

    AccessorReader& accessors_;
    /// Maps a vertex to its number in the primitive that is being read. read() resets only the entries that
    /// it used: resetting all for each primitive would take time proportional to vertices times primitives.
    std::vector<std::uint32_t> number_of_;
};

/// Returns the attribute `name` of the vertices `vertices`, `components` numbers each; nothing if the
/// primitive does not have it. Throws InputError for a wrong type, and if its length differs from that of
/// POSITION.
[[nodiscard]] std::vector<float> read_attribute(AccessorReader& accessors,
                                                const tinygltf::Primitive& primitive, const char* name,
                                                int components, std::span<const std::uint32_t> vertices);

/// Returns the attributes of the vertices `vertices`. Throws InputError as read_attribute() does.
[[nodiscard]] Attributes read_attributes(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                                         std::span<const std::uint32_t> vertices);

}  // namespace common::gltf
