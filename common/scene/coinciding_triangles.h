// Triangles that lie over others in the same plane, so that rounding would decide which of them a ray meets.
#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/scene.h"

namespace common {

/// Whether light is meant to meet the material on both faces of a triangle. Where another triangle at the
/// same place looks the other way, each of them is there for its own side otherwise.
[[nodiscard]] inline bool is_for_both_faces(const Material& material) {
    return material.double_sided || material.kind == SurfaceKind::dielectric ||
           material.kind == SurfaceKind::thin_sheet;
}

struct CoincidingTriangles {
    /// All that have an area in common with another, ascending. Where so many lie over each other that
    /// comparing all would take long, also some that might.
    std::vector<std::uint32_t> triangle;

    /// How many lie over one before them in the file, with a side that both are there for, and the area of
    /// these parts in square world units.
    std::size_t covering = 0;
    double area = 0;

    bool all_compared = true;  ///< otherwise `covering` and `area` are the least that there is
};

/// What overlaps by more than `tolerance` (world units) in every direction and lies within `tolerance` of one
/// plane, whichever way it faces. Triangles narrower than `tolerance` are left out. The same answer on any
/// number of threads.
[[nodiscard]] CoincidingTriangles find_coinciding_triangles(const Scene& scene, float tolerance);

}  // namespace common
