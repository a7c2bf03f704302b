// Converts the meshes of nodes to world-space triangles.
#pragma once

#include <tiny_gltf.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Appends one MeshInstance, with its vertices and triangles, for every triangle primitive of every visible
/// node's mesh, once for each of its instances (EXT_mesh_gpu_instancing). The materials must be in the scene
/// already. Morph targets and skins are applied in their pose without animation. Throws InputError for an
/// invalid primitive, for positions that are not finite in world space, for more vertices or triangles than
/// 32 bits can count, and for more instances than fit into memory. Returns the bounds of all triangles,
/// including those that are left out because floats give them no area.
Imath::Box3f append_meshes(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                           Warnings& warnings);

}  // namespace common::gltf
