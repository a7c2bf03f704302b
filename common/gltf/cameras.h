// Perspective cameras.
#pragma once

#include <tiny_gltf.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Appends the perspective camera of every node that has one, visible or not (KHR_node_visibility). Leaves
/// out, with a warning, orthographic cameras and cameras under a node whose transform leaves no direction. A
/// camera takes position and direction from its node, but no scale. Throws InputError for a field of view
/// outside (0, pi).
void append_cameras(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                    Warnings& warnings);

}  // namespace common::gltf
