// A camera for scenes that bring none.
#pragma once

#include "common/tracer/ray_scene.h"

namespace common {

/// Of a fixed set of viewpoints, inside the bounds and around them, the one that sees the most: many front
/// faces, far apart. For open objects that is from outside, for closed rooms from a corner within.
[[nodiscard]] Camera place_camera(const RayScene& rays);

/// Looks from `eye` to `target`; `vertical_fov` in radians. Throws InputError where the two coincide.
[[nodiscard]] Camera look_at(const Vec3& eye, const Vec3& target, float vertical_fov);

}  // namespace common
