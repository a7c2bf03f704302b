// A piece of surface flattened into a rectangle.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/core/vector.h"

namespace shlm {

/// A rectangle in the world.
struct ChartPlane {
    Imath::V3d origin;       ///< its corner
    Imath::V3d right, down;  ///< unit, along its sides
};

struct TexelChart {
    /// Sides of the rectangle in the world, as if it were covered completely; world units.
    double width = 0, height = 0;
    bool both_faces = false;  ///< the backs have a rectangle of their own

    std::vector<std::uint32_t> triangle;  ///< of the scene
    /// One per triangle: the positions of its corners, with the rectangle as the unit square.
    std::vector<std::array<common::Vec2, 3>> corner;
    /// The plane to which the corners were projected perpendicularly; none if they come from lightmap
    /// coordinates.
    std::optional<ChartPlane> plane;
};

}  // namespace shlm
