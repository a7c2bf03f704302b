// Triangles that overlap others in the same plane, so that rounding would decide which of them a ray hits.
#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/scene.h"

namespace common {

/// Returns whether light may hit the material on both faces of a triangle. Otherwise, of two triangles at the
/// same place that face opposite ways, each is hit on its own side only.
[[nodiscard]] inline bool is_for_both_faces(const Material& material) {
    return material.double_sided || material.kind == SurfaceKind::dielectric ||
           material.kind == SurfaceKind::thin_sheet;
}

struct CoincidingTriangles {
    /// All that have an area in common with another, ascending. Where so many overlap that comparing all
    /// would take long, also some that might.
    std::vector<std::uint32_t> triangle;

    /// The number of triangles that overlap an earlier one in the file on a side on which light may hit both,
    /// and the area of these overlaps in square world units.
    std::size_t covering = 0;
    double area = 0;

    bool all_compared = true;  ///< if false, `covering` and `area` are lower bounds
};

/// Finds triangles that overlap by more than `tolerance` (world units) in every direction and lie within
/// `tolerance` of one plane, whichever way they face. Leaves out triangles narrower than `tolerance`. The
/// result does not depend on the number of threads.
[[nodiscard]] CoincidingTriangles find_coinciding_triangles(const Scene& scene, float tolerance);

}  // namespace common
