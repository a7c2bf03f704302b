// Order 2 written as a polynomial of the normal, and its fit over one hemisphere.
#pragma once

#include <Imath/ImathMatrix.h>

#include "shlm/basis/texel_model.h"

namespace shlm {

/// One channel's irradiance: constant + linear . n + n^T matrix n, with a symmetric matrix of trace 0. W/m^2.
struct QuadraticLight {
    float constant = 0;
    common::Vec3 linear{0, 0, 0};
    Imath::M33f matrix{0, 0, 0, 0, 0, 0, 0, 0, 0};

    [[nodiscard]] float at(const common::Vec3& n) const {
        return constant + linear.dot(n) + n.dot(n * matrix);
    }
};

/// Returns the same light as in Ramamoorthi and Hanrahan (2001), eq. 11 and 12: sh_basis.h's bands 0 to 2
/// multiplied out. `coefficients` has one for each harmonic, W/m^2.
[[nodiscard]] inline QuadraticLight quadratic_light(
    const std::array<float, harmonic_count(2)>& coefficients) {
    using namespace sh_constants;
    const auto& e = coefficients;
    const float xy = c2 / 2 * e[4], yz = c2 / 2 * e[5], xz = c2 / 2 * e[7];
    const float zz = 2 * c20 * e[6];  // 3 z^2 - 1 is 2 z^2 - x^2 - y^2
    const float difference = c22 * e[8];
    return {c0 * e[0],
            common::Vec3(e[3], e[1], e[2]) * c1,
            {-zz / 2 + difference, xy, xz, xy, -zz / 2 - difference, yz, xz, yz, zz}};
}

/// Returns the best approximation without a quadratic part: least squares over the normals n with n .
/// face_normal >= 0, uniformly weighted (the span {1, x, y, z} of the hemispherical basis H4, Habel and
/// Wimmer 2010).
///
/// In a frame whose z is the face's normal, the part of n^T M n along z is m (3 z^2 - 1) / 2. Its best
/// approximation is m (3 z - 1.5) / 2, as z is uniform from 0 to 1 there. That of 2 m' x z is 3/4 m' x. The
/// functions x y and x^2 - y^2 are orthogonal to all four.
[[nodiscard]] inline QuadraticLight hemisphere_fit(const QuadraticLight& light,
                                                   const common::Vec3& face_normal) {
    const common::Vec3 along = face_normal * light.matrix;
    const float zz = face_normal.dot(along);
    return {light.constant - 0.75f * zz,
            light.linear + (along + face_normal * zz) * 0.75f,
            {0, 0, 0, 0, 0, 0, 0, 0, 0}};
}

/// Returns channel c of harmonics.
template <std::size_t Count>
[[nodiscard]] inline std::array<float, Count> channel_of(const std::array<common::Rgb, Count>& light, int c) {
    std::array<float, Count> channel;
    for (std::size_t i = 0; i < Count; ++i) channel[i] = light[i][c];
    return channel;
}

/// Returns the mean of the channels, whose shape stands for all three where only one shape is kept.
template <std::size_t Count>
[[nodiscard]] inline std::array<float, Count> grey_of(const std::array<common::Rgb, Count>& light) {
    std::array<float, Count> grey;
    for (std::size_t i = 0; i < Count; ++i) grey[i] = common::mean_component(light[i]);
    return grey;
}

}  // namespace shlm
