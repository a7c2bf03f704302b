// Finds the triangles that share places of the lightmap.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vector.h"

namespace shlm {

using UvTriangle = std::array<common::Vec2, 3>;

/// Returns twice the area, positive if the corners are counter-clockwise. In double, so that the sign is
/// right for float coordinates.
[[nodiscard]] inline double signed_double_area(const UvTriangle& t) {
    const Imath::V2d a(t[0]), ab = Imath::V2d(t[1]) - a, ac = Imath::V2d(t[2]) - a;
    return ab.x * ac.y - ab.y * ac.x;
}

/// Two triangles that cover the same places.
struct UvOverlap {
    std::uint32_t first, second;  ///< indices, the lower first
    double area;                  ///< covered by both
};

/// Returns the pairs of triangles whose coordinates overlap by more than the rounding where charts touch: a
/// 16,384th of the bounds' longer side, or a twentieth of the smaller triangle's height if that is less.
/// Triangles without area overlap nothing. If triangles overlap many others, perhaps all in one place as with
/// repeating textures, some overlaps are left out, but only between triangles that have at least 16.
[[nodiscard]] std::vector<UvOverlap> find_uv_overlaps(std::span<const UvTriangle> triangles);

}  // namespace shlm
