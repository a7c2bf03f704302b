// How much light gets along a straight line: past what is solid, through holes and thin sheets.
#pragma once

#include "common/tracer/ray_scene.h"

namespace common::reference {

/// Whether anything in the scene lets light through as it comes.
[[nodiscard]] bool has_see_through(const Scene& scene);

/// The part of the light, for each channel, that gets from `origin + direction * reach` to `origin`.
/// `direction` may have any length but 0; `reach` may be infinite.
[[nodiscard]] Imath::V3d part_that_arrives(const RayScene& rays, Vec3 origin, Vec3 direction, float reach);

}  // namespace common::reference
