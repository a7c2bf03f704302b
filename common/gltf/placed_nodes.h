// The nodes of the scene with their transforms to world space.
#pragma once

#include <Imath/ImathMatrix.h>
#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "common/core/vector.h"

namespace common::gltf {

/// A node of the scene.
struct PlacedNode {
    int node;              ///< index into the model's nodes
    Imath::M44d to_world;  ///< affine; for row vectors, as Imath has them: world = local * to_world

    /// A direction of the node's own space in world space, unit. Throws InputError where the transform
    /// flattens it.
    [[nodiscard]] Vec3 direction(const Imath::V3d& local) const;
    [[nodiscard]] Vec3 origin() const { return Vec3(to_world.translation()); }
};

/// All nodes under the roots of the default scene; of the first scene where the file names none, and of the
/// whole file where it has no scenes. Throws InputError where a node is reached twice (a loop, or two
/// parents) and for a transform that is not finite or not affine.
[[nodiscard]] std::vector<PlacedNode> place_nodes(const tinygltf::Model& model);

/// The node's name, or its place in the file where it has none.
[[nodiscard]] std::string node_name(const tinygltf::Model& model, int node);

}  // namespace common::gltf
