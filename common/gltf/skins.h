// Skinned meshes in the pose that their joints' nodes have: glTF 2.0, section 3.7.3.
#pragma once

#include <Imath/ImathMatrix.h>
#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/gltf/accessor.h"
#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"

namespace common::gltf {

/// The skins of a model whose nodes are placed.
class Skins {
  public:
    Skins(const tinygltf::Model& model, std::span<const PlacedNode> nodes, AccessorReader& accessors);

    /// Returns for every joint of the skin the transform of a vertex to world space: affine, for row vectors
    /// as PlacedNode::to_world. Returns nothing if a joint is not in the scene. Throws InputError for inverse
    /// bind matrices of a wrong type, too few of them, and ones that are not finite or not affine.
    [[nodiscard]] std::vector<Imath::M44d> joints_to_world(int skin) const;

  private:
    const tinygltf::Model& model_;
    AccessorReader& accessors_;
    std::vector<const PlacedNode*> placed_;  ///< per node of the model; null where it is not in the scene
};

/// Returns true if a primitive says which joints move its vertices.
[[nodiscard]] bool has_joints(const tinygltf::Primitive& primitive);

/// Returns the transform of each of `vertices` to world space: the mean of its joints' transforms by its
/// weights. Warns, naming the mesh `name`, of vertices without weights, which follow their first joint.
/// Throws InputError for attributes of a wrong type or length and for joints that the skin does not have.
[[nodiscard]] std::vector<Imath::M44d> vertices_to_world(AccessorReader& accessors,
                                                         const tinygltf::Primitive& primitive,
                                                         std::span<const Imath::M44d> joints_to_world,
                                                         std::span<const std::uint32_t> vertices,
                                                         const std::string& name, Warnings& warnings);

}  // namespace common::gltf
