// Meshes under their nodes -> world-space triangles.
#pragma once

#include <tiny_gltf.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Appends one MeshInstance, with its vertices and triangles, for every triangle primitive of every node's
/// mesh; needs the materials to be there. Throws InputError for what is wrong with a primitive, for positions
/// that are not finite in world space, and for more vertices or triangles than 32 bits can count. Returns the
/// bounds of all triangles, also of those that are left out as floats leave them no area.
Imath::Box3f append_meshes(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                           Warnings& warnings);

}  // namespace common::gltf
