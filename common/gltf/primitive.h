// What one mesh primitive holds, in the space of its node.
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

/// Vertex attributes. Each list has one entry per vertex, or none where the file does not have it.
struct Attributes {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;
    std::vector<Vec3> tangent;
    std::vector<float> tangent_sign;
    std::array<std::vector<Vec2>, 2> texcoord;
};

/// The triangles of a primitive, and those of its vertices that they use: many primitives can share the lists
/// of vertices of a whole file.
struct PrimitiveTriangles {
    std::vector<TriangleVertices> triangle;  ///< corners as indices into `vertex`
    std::vector<std::uint32_t> vertex;       ///< places in the primitive's attributes, in order of first use
};

/// True for the modes TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN.
[[nodiscard]] bool is_made_of_triangles(const tinygltf::Primitive& primitive);

/// Reads the triangles of the primitives of a model.
class TriangleReader {
  public:
    explicit TriangleReader(AccessorReader& accessors) : accessors_(accessors) {}

    /// Listed or counted off, out of a list, strip or fan; vertices that are left over make none. Throws
    /// InputError for an index beyond the vertices.
    [[nodiscard]] PrimitiveTriangles read(const tinygltf::Primitive& primitive);

  private:
    [[nodiscard]] std::vector<std::uint32_t> number_vertices(std::span<TriangleVertices> triangles,
                                                             std::uint32_t vertex_count);

    AccessorReader& accessors_;
    /// For every vertex its number in the primitive that is read. Between two of them nothing has one:
    /// setting them all for each would take as long as all vertices times all primitives.
    std::vector<std::uint32_t> number_of_;
};

/// The attribute `name` of the vertices `vertices`, `components` numbers each; nothing where the primitive
/// does not have it. Throws InputError for a wrong type and where it has not as many elements as POSITION.
[[nodiscard]] std::vector<float> read_attribute(AccessorReader& accessors,
                                                const tinygltf::Primitive& primitive, const char* name,
                                                int components, std::span<const std::uint32_t> vertices);

/// The attributes of the vertices `vertices`. Throws InputError as read_attribute().
[[nodiscard]] Attributes read_attributes(AccessorReader& accessors, const tinygltf::Primitive& primitive,
                                         std::span<const std::uint32_t> vertices);

}  // namespace common::gltf
