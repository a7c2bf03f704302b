// Scenes so far from their origin that floats cannot resolve their details.
#pragma once

#include <Imath/ImathBox.h>

#include <span>

#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"
#include "common/scene/scene.h"

namespace common::gltf {

/// Returns the origin for geometry within `bounds` (Scene::origin): zero unless coordinates exceed 256 times
/// the diagonal. At that distance, floats are spaced by a 30,000th of the diagonal, and rays start a 2,000th
/// of it off their surfaces (RayScene::off_surface).
[[nodiscard]] Imath::V3d origin_for(const Imath::Box3f& bounds);

/// Moves the nodes so that `origin` becomes the origin of world space.
void move_origin(const Imath::V3d& origin, std::span<PlacedNode> nodes);

/// Warns of instances that are still too far away: rays start more than a 64th of their size off their
/// surfaces.
void warn_about_far_instances(const Scene& scene, Warnings& warnings);

}  // namespace common::gltf
