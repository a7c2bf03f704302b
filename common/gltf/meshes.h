// Meshes under their nodes -> world-space triangles.
#pragma once

#include <tiny_gltf.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Appends one MeshInstance, with its vertices and triangles, for every triangle primitive of every visible
/// node's mesh, as often as the node has it by EXT_mesh_gpu_instancing; needs the materials to be there.
/// Morph targets and skins are applied as they are where no animation plays. Throws InputError for what is
/// wrong with a primitive, for positions that are not finite in world space, for more vertices or triangles
/// than 32 bits can count, and for more instances than there is memory for. Returns the bounds of all
/// triangles, also of those that are left out as floats leave them no area.
Imath::Box3f append_meshes(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                           Warnings& warnings);

}  // namespace common::gltf
