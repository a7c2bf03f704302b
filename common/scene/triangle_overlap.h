// The area in which two triangles are the same surface.
#pragma once

#include <array>

#include "common/core/vector.h"

namespace common {

using TriangleCorners = std::array<Vec3, 3>;

/// Returns the shortest height of a triangle, world units; 0 if it has no area.
[[nodiscard]] double narrowest_width(const TriangleCorners& triangle);

/// Returns the area that two triangles have in common, square world units, whichever way each faces. They
/// must overlap by more than `tolerance` (world units) in every direction and lie within `tolerance` of one
/// plane; otherwise it is 0. So neighbours, and surfaces that cross, have no area in common.
[[nodiscard]] double common_area(const TriangleCorners& a, const TriangleCorners& b, double tolerance);

}  // namespace common
