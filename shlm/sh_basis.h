// Real spherical harmonics up to order 2 and their turn from radiance into irradiance.
#pragma once

#include <array>
#include <numbers>

#include "common/core/vector.h"

namespace shlm {

inline constexpr std::size_t coefficient_count = 9;

/// One value per harmonic, indexed by l (l + 1) + m.
using ShValues = std::array<float, coefficient_count>;

/// Orthonormal real harmonics at a unit direction: Y00, Y1-1, Y10, Y11, Y2-2, Y2-1, Y20, Y21, Y22, without
/// the Condon-Shortley sign (Ramamoorthi and Hanrahan 2001, eq. 3).
[[nodiscard]] inline ShValues evaluate_sh(const common::Vec3& d) {
    constexpr float c0 = 0.282094792f;   // 1 / 2 sqrt(1 / pi)
    constexpr float c1 = 0.488602512f;   // 1 / 2 sqrt(3 / pi)
    constexpr float c2 = 1.092548431f;   // 1 / 2 sqrt(15 / pi)
    constexpr float c20 = 0.315391565f;  // 1 / 4 sqrt(5 / pi)
    constexpr float c22 = 0.546274215f;  // 1 / 4 sqrt(15 / pi)
    return {c0,
            c1 * d.y,
            c1 * d.z,
            c1 * d.x,
            c2 * d.x * d.y,
            c2 * d.y * d.z,
            c20 * (3 * d.z * d.z - 1),
            c2 * d.x * d.z,
            c22 * (d.x * d.x - d.y * d.y)};
}

/// Band factors of the clamped cosine: irradiance coefficient = factor * radiance coefficient. Pi, 2 pi / 3,
/// pi / 4 for l = 0, 1, 2 (Ramamoorthi and Hanrahan 2001, eq. 8 and 9).
inline constexpr ShValues cosine_factors = [] {
    constexpr float a0 = std::numbers::pi_v<float>, a1 = a0 * 2 / 3, a2 = a0 / 4;
    return ShValues{a0, a1, a1, a1, a2, a2, a2, a2, a2};
}();

}  // namespace shlm
