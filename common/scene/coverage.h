// Coverage of surfaces: alpha makes holes in them.
#pragma once

#include "common/scene/surface_point.h"

namespace common {

/// Returns the fraction of the surface that is present, in [0, 1] (glTF 2.0, section 3.9.4). The rest is a
/// hole, through which light and camera rays pass unchanged.
[[nodiscard]] float coverage_at(const Scene& scene, const SurfaceId& surface);

/// Bounds of coverage_at() over a triangle, found without reading its texture.
struct CoverageRange {
    float least = 1, most = 1;

    [[nodiscard]] bool has_holes() const { return least < 1; }
    [[nodiscard]] bool is_nowhere() const { return most == 0; }
};

[[nodiscard]] CoverageRange coverage_range(const Scene& scene, std::uint32_t triangle);

}  // namespace common
