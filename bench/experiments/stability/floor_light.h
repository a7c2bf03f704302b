// Light on parts of a flat floor, and points on it.
#pragma once

#include "bench/experiments/stability/known_light.h"

namespace bench::stability {

/// Makes one quad (scene_builder.h) at z = 0, centred on the origin and facing up, with u along x and v along
/// y.
[[nodiscard]] common::Scene square_floor(double width);

/// Returns the surface coordinates of (x, y) on that floor.
[[nodiscard]] common::SurfaceId on_floor(double width, double x, double y);

/// Returns the same point, seen from above.
[[nodiscard]] common::SurfacePoint floor_point(const common::Scene& floor, double width, double x, double y);

/// Returns 64 points of a quad at `s` along its u, evenly spaced along v and away from its ends.
[[nodiscard]] std::vector<common::SurfacePoint> points_across(const common::Scene& scene,
                                                              std::uint32_t first_triangle, double s);

/// Returns the photons that arrive where `is_lit(position)`; the others are taken as blocked.
template <class IsLit>
[[nodiscard]] common::HitBatch lit_where(const common::HitBatch& hits, IsLit is_lit) {
    common::HitBatch lit;
    lit.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (is_lit(hits.position[i]))
            lit.push_back(hits.position[i], hits.direction[i], hits.flux[i], hits.surface[i]);
    return lit;
}

}  // namespace bench::stability
