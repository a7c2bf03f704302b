// The places in which a node has its mesh drawn: its own, or those of EXT_mesh_gpu_instancing.
#pragma once

#include <Imath/ImathMatrix.h>
#include <tiny_gltf.h>

#include <optional>
#include <string>

#include "common/gltf/accessor.h"
#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"

namespace common::gltf {

/// The instances of one node's mesh. Nothing is kept for each: a short file can ask for very many.
class MeshInstances {
  public:
    /// Warns of instance attributes that are neither a transform nor the application's own. Throws InputError
    /// for those of a wrong type or of different length, and for none.
    MeshInstances(const tinygltf::Model& model, const PlacedNode& node, AccessorReader& accessors,
                  Warnings& warnings);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// True where EXT_mesh_gpu_instancing lists them, be it one.
    [[nodiscard]] bool are_listed() const { return are_listed_; }
    /// Of instance `i`; affine, for row vectors as PlacedNode::to_world. Throws InputError for a rotation
    /// that is none and for a transform that is not finite.
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
