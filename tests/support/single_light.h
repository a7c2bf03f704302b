// Single lights over a texel that faces up, and the truncated series of their irradiance.
#pragma once

#include <cmath>
#include <numbers>

#include "bench/experiments/bases/environment.h"

namespace tests {

inline constexpr double pi = std::numbers::pi;

inline common::Vec3 direction_in_xz(double degrees) {
    const double angle = degrees * pi / 180;
    return common::Vec3(Imath::V3d(std::sin(angle), 0, std::cos(angle)));
}

inline bench::bases::Environment one_light(double degrees) {
    const common::Vec3 towards_light = direction_in_xz(degrees);
    return {{towards_light, towards_light.z}};
}

/// Returns the irradiance of a plane under one light of irradiance 1, truncated after the band `order`; x is
/// the cosine between the two. Written with Legendre polynomials (Ramamoorthi and Hanrahan 2001, eq. 8).
inline double truncated_kernel(int order, double x) {
    double sum = 0.25;
    if (order >= 1) sum += 0.5 * x;
    if (order >= 2) sum += 5.0 / 32 * (3 * x * x - 1);
    if (order >= 4) sum -= 3.0 / 256 * (35 * x * x * x * x - 30 * x * x + 3);
    return sum;
}

}  // namespace tests
