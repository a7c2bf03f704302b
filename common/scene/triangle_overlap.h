// Where two triangles are the same surface.
#pragma once

#include <array>

#include "common/core/vector.h"

namespace common {

using TriangleCorners = std::array<Vec3, 3>;

/// Shortest height of a triangle, world units: how wide it is where it is narrowest. 0 where it has no area.
[[nodiscard]] double narrowest_width(const TriangleCorners& triangle);

/// Area that two triangles have in common, square world units: where they overlap by more than `tolerance`
/// (world units) in every direction and lie within `tolerance` of one plane, whichever way each of them
/// faces. 0 where they do not: neighbours have no area in common, nor have surfaces that cross.
[[nodiscard]] double common_area(const TriangleCorners& a, const TriangleCorners& b, double tolerance);

}  // namespace common
