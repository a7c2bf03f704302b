// A camera for scenes without one.
#pragma once

#include "common/tracer/ray_scene.h"

namespace common {

/// Returns the camera that sees the most, of a fixed set inside the bounds and around them: many front faces,
/// far away. For open objects that is from outside, for closed rooms from a corner within.
[[nodiscard]] Camera place_camera(const RayScene& rays);

/// Returns a camera at `eye` that looks at `target`; `vertical_fov` in radians. Throws InputError if the two
/// coincide.
[[nodiscard]] Camera look_at(const Vec3& eye, const Vec3& target, float vertical_fov);

}  // namespace common
