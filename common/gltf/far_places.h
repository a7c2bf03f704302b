// Scenes that lie farther from their origin than floats can tell their parts apart.
#pragma once

#include <Imath/ImathBox.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Where to have the origin for what lies within `bounds` (Scene::origin): zero unless coordinates are more
/// than 256 times the diagonal, of which floats then resolve less than a 30,000th and rays start a 2,000th
/// off their surfaces (RayScene::off_surface).
[[nodiscard]] Imath::V3d origin_for(const Imath::Box3f& bounds);

/// Moves the nodes so that the world has its origin at `origin`.
void move_origin(const Imath::V3d& origin, std::span<PlacedNode> nodes);

/// Warns of instances that are still too far away: rays start more than a 64th of their size off them.
void warn_about_far_instances(const Scene& scene, Warnings& warnings);

}  // namespace common::gltf
