// Directions that are uniformly distributed over a cap of the sphere.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "common/core/vector.h"

namespace bench::bases {

/// Returns `count` unit vectors with z above `least_cosine`, each in the middle of an equal share of the
/// cap's solid angle. They form a Fibonacci lattice: z in equal steps and azimuth in steps of the golden
/// section (Swinbank and Purser, "Fibonacci grids", 2006).
[[nodiscard]] inline std::vector<common::Vec3> directions_in_cap(std::size_t count, double least_cosine) {
    std::vector<common::Vec3> directions(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto place = static_cast<double>(i);
        const double z = least_cosine + (1 - least_cosine) * (place + 0.5) / static_cast<double>(count);
        const double turns = place / std::numbers::phi;
        const double azimuth = 2 * std::numbers::pi * (turns - std::floor(turns));
        const double r = std::sqrt(1 - z * z);
        directions[i] = common::Vec3(Imath::V3d(r * std::cos(azimuth), r * std::sin(azimuth), z));
    }
    return directions;
}

/// Returns the solid angle of such a cap, sr.
[[nodiscard]] inline double cap_solid_angle(double least_cosine) {
    return 2 * std::numbers::pi * (1 - least_cosine);
}

}  // namespace bench::bases
