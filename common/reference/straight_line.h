// Transmittance along a straight line: through holes and thin sheets, but not through solid surfaces.
#pragma once

#include "common/tracer/ray_scene.h"

namespace common::reference {

/// Returns whether anything in the scene transmits light without bending.
[[nodiscard]] bool has_see_through(const Scene& scene);

/// Returns the fraction of light, per channel, that gets from `origin + direction * reach` to `origin`.
/// `direction` may have any length but 0; `reach` may be infinite.
[[nodiscard]] Imath::V3d part_that_arrives(const RayScene& rays, Vec3 origin, Vec3 direction, float reach);

}  // namespace common::reference
