// How much of a surface is there: alpha makes holes in it.
#pragma once

#include "common/scene/surface_point.h"

namespace common {

/// The part of the surface that is there, in [0, 1] (glTF 2.0, section 3.9.4): the rest is a hole, through
/// which light and eyes go as if there were nothing.
[[nodiscard]] float coverage_at(const Scene& scene, const SurfaceId& surface);

/// Bounds of coverage_at over a triangle, without a look into its texture.
struct CoverageRange {
    float least = 1, most = 1;

    [[nodiscard]] bool has_holes() const { return least < 1; }
    [[nodiscard]] bool is_nowhere() const { return most == 0; }
};

[[nodiscard]] CoverageRange coverage_range(const Scene& scene, std::uint32_t triangle);

}  // namespace common
