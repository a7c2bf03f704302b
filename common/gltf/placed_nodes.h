// The nodes of the scene with their transforms to world space.
#pragma once

#include <Imath/ImathMatrix.h>
#include <tiny_gltf.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace common::gltf {

/// A node of the scene.
struct PlacedNode {
    int node;              ///< index into the model's nodes
    Imath::M44d to_world;  ///< affine; for row vectors, as Imath has them: world = local * to_world
    bool is_visible;       ///< false where KHR_node_visibility hides it or a node above it

    /// Returns the unit direction in world space of a direction in the node's space; nothing if the transform
    /// flattens it.
    [[nodiscard]] std::optional<Vec3> direction(const Imath::V3d& local) const;
    [[nodiscard]] Vec3 origin() const { return Vec3(to_world.translation()); }
};

/// Returns all nodes under the roots of the default scene, else of the first scene, else of the whole file if
/// it has no scenes. Throws InputError if a node is reached twice (a loop, or two parents) and for a
/// transform that is not finite or not affine.
[[nodiscard]] std::vector<PlacedNode> place_nodes(const tinygltf::Model& model);

/// Returns the node's name, or its place in the file if it has none.
[[nodiscard]] std::string node_name(const tinygltf::Model& model, int node);

/// Converts glTF's column-major matrix for column vectors (16 numbers) to a matrix for row vectors.
template <class Number>
[[nodiscard]] Imath::M44d matrix_of(std::span<const Number> elements) {
    // Both have the same layout in memory, as Imath's matrix is row-major.
    Imath::M44d matrix;
    for (std::size_t i = 0; i < 16; ++i) matrix.getValue()[i] = static_cast<double>(elements[i]);
    return matrix;
}

/// Returns the transform that scales, then rotates by the quaternion (x, y, z, w) of any length, then
/// translates. Throws InputError for a quaternion without a direction.
[[nodiscard]] Imath::M44d transform_of(const Imath::V3d& scale, const std::array<double, 4>& rotation,
                                       const Imath::V3d& translation);

/// Throws InputError for a transform that is not finite as floats or not affine.
void check_transform(const Imath::M44d& matrix);

}  // namespace common::gltf
