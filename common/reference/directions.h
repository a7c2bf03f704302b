// Directions over a hemisphere for the reference, constructed differently from the photon tracer's.
#pragma once

#include <array>
#include <numbers>

#include "common/core/vector.h"

namespace common::reference {

/// Maps a point of the unit square to the unit disc, with areas in proportion (Shirley and Chiu, "A Low
/// Distortion Map Between Disk and Square", 1997).
[[nodiscard]] inline std::array<double, 2> concentric_disc(const std::array<double, 2>& square) {
    constexpr double quarter_pi = std::numbers::pi / 4;
    const double a = 2 * square[0] - 1, b = 2 * square[1] - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle = wide ? quarter_pi * b / a : 2 * quarter_pi - quarter_pi * a / b;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Two unit vectors perpendicular to a unit vector and to each other.
struct Tangents {
    Imath::V3d first, second;

    /// Derives the first from the coordinate axis that is closest to the tangent plane.
    explicit Tangents(const Imath::V3d& normal) {
        const Imath::V3d length(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
        Imath::V3d helper(0, 0, 0);
        helper[length.x <= length.y && length.x <= length.z ? 0 : length.y <= length.z ? 1 : 2] = 1;
        first = normal.cross(helper).normalized();
        second = normal.cross(first);
    }
};

/// Returns a unit direction around the unit vector `axis` with density cos / pi: a point of the disc lifted
/// to the hemisphere (Malley's method).
[[nodiscard]] inline Vec3 cosine_direction(const Vec3& axis, const std::array<double, 2>& square) {
    using Imath::V3d;
    const auto [x, y] = concentric_disc(square);
    const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    const V3d normal(axis);
    const Tangents tangents(normal);
    return Vec3((tangents.first * x + tangents.second * y + normal * z).normalized());
}

}  // namespace common::reference
