// The instances of a node's mesh: one, or those of EXT_mesh_gpu_instancing.
#pragma once

#include <Imath/ImathMatrix.h>
#include <tiny_gltf.h>

#include <optional>
#include <string>

#include "common/gltf/accessor.h"
#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"

namespace common::gltf {

/// The instances of one node's mesh. Stores nothing per instance, as a short file can ask for very many.
class MeshInstances {
  public:
    /// Warns of instance attributes that are neither a transform nor application-specific. Throws InputError
    /// for attributes of a wrong type or of different lengths, and if an instanced node has none.
    MeshInstances(const tinygltf::Model& model, const PlacedNode& node, AccessorReader& accessors,
                  Warnings& warnings);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// Returns true if EXT_mesh_gpu_instancing lists the instances, even if it is only one.
    [[nodiscard]] bool are_listed() const { return are_listed_; }
    /// Returns the transform of instance `i`: affine, for row vectors as PlacedNode::to_world. Throws
    /// InputError for an invalid rotation and for a transform that is not finite.
    [[nodiscard]] Imath::M44d to_world(std::size_t i) const;

  private:
    void read_attribute(const std::string& name, int accessor, std::size_t count);

    const PlacedNode& node_;
    AccessorReader& accessors_;
    bool are_listed_ = false;
    std::size_t count_ = 1;
    std::optional<int> translation_, rotation_, scale_;  ///< accessors
};

}  // namespace common::gltf
