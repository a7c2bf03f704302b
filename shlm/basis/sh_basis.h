// Real spherical harmonics and their conversion from radiance to irradiance.
#pragma once

#include <array>
#include <numbers>

#include "common/core/vector.h"

namespace shlm {

/// Returns the number of harmonics of irradiance up to an order. The clamped cosine has no band 3. So order 4
/// leaves those seven out, and order 3 would be the same as order 2.
[[nodiscard]] constexpr std::size_t harmonic_count(int order) {
    return order == 0 ? 1 : order == 1 ? 4 : order == 2 ? 9 : 18;
}

template <int Order>
concept SupportedOrder = Order == 0 || Order == 1 || Order == 2 || Order == 4;

/// One value per harmonic: bands 0, 1, 2 and 4 one after the other, m from -l to l within each.
template <int Order>
requires SupportedOrder<Order>
using ShValues = std::array<float, harmonic_count(Order)>;

/// Normalisation constants of evaluate_sh's polynomials, by band and |m|. The viewer's fragment program gets
/// them from here.
namespace sh_constants {
inline constexpr float c0 = 0.282094792f;   // 1 / 2 sqrt(1 / pi)
inline constexpr float c1 = 0.488602512f;   // 1 / 2 sqrt(3 / pi)
inline constexpr float c2 = 1.092548431f;   // 1 / 2 sqrt(15 / pi)
inline constexpr float c20 = 0.315391565f;  // 1 / 4 sqrt(5 / pi)
inline constexpr float c22 = 0.546274215f;  // 1 / 4 sqrt(15 / pi)
inline constexpr float c40 = 0.105785547f;  // 3 / 16 sqrt(1 / pi)
inline constexpr float c41 = 0.669046544f;  // 3 / 4 sqrt(5 / (2 pi))
inline constexpr float c42 = 0.473087348f;  // 3 / 8 sqrt(5 / pi)
inline constexpr float c43 = 1.770130769f;  // 3 / 4 sqrt(35 / (2 pi))
inline constexpr float c44 = 0.625835735f;  // 3 / 16 sqrt(35 / pi)
}  // namespace sh_constants

/// Returns the orthonormal real harmonics at a unit direction, without the Condon-Shortley sign (Ramamoorthi
/// and Hanrahan 2001, eq. 3, for bands 0 to 2).
template <int Order>
[[nodiscard]] inline ShValues<Order> evaluate_sh(const common::Vec3& d) {
    using namespace sh_constants;
    ShValues<Order> y;
    y[0] = c0;
    if constexpr (Order >= 1) {
        y[1] = c1 * d.y;
        y[2] = c1 * d.z;
        y[3] = c1 * d.x;
    }
    const float xx = d.x * d.x, yy = d.y * d.y, zz = d.z * d.z;
    const float xy = d.x * d.y, yz = d.y * d.z, xz = d.x * d.z;
    if constexpr (Order >= 2) {
        y[4] = c2 * xy;
        y[5] = c2 * yz;
        y[6] = c20 * (3 * zz - 1);
        y[7] = c2 * xz;
        y[8] = c22 * (xx - yy);
    }
    if constexpr (Order >= 4) {
        y[9] = 4 * c44 * xy * (xx - yy);
        y[10] = c43 * yz * (3 * xx - yy);
        y[11] = 2 * c42 * xy * (7 * zz - 1);
        y[12] = c41 * yz * (7 * zz - 3);
        y[13] = c40 * (35 * zz * zz - 30 * zz + 3);
        y[14] = c41 * xz * (7 * zz - 3);
        y[15] = c42 * (xx - yy) * (7 * zz - 1);
        y[16] = c43 * xz * (xx - 3 * yy);
        y[17] = c44 * (xx * (xx - 3 * yy) - yy * (3 * xx - yy));
    }
    return y;
}

/// Band factors of the clamped cosine, one per harmonic: irradiance coefficient = factor * radiance
/// coefficient. Pi, 2 pi / 3, pi / 4 and -pi / 24 for l = 0, 1, 2, 4 (Ramamoorthi and Hanrahan 2001, eq. 8
/// and 9).
template <int Order>
inline constexpr ShValues<Order> cosine_factors = [] {
    constexpr float pi = std::numbers::pi_v<float>;
    ShValues<Order> factors{};
    for (std::size_t i = 0; i < factors.size(); ++i)
        factors[i] = i == 0 ? pi : i < 4 ? pi * 2 / 3 : i < 9 ? pi / 4 : -pi / 24;
    return factors;
}();

}  // namespace shlm
