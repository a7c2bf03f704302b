// Directions and points from uniform random numbers.
#pragma once

#include <numbers>

#include "common/core/vector.h"

namespace common {

/// Orthonormal tangents around a unit vector (Duff et al., "Building an Orthonormal Basis, Revisited", 2017).
struct Frame {
    Vec3 tangent, bitangent, normal;

    explicit Frame(const Vec3& unit_normal) : normal(unit_normal) {
        const float sign = std::copysign(1.0f, normal.z);
        const float a = -1.0f / (sign + normal.z);
        const float b = normal.x * normal.y * a;
        tangent = {1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
        bitangent = {b, sign + normal.y * normal.y * a, -normal.y};
    }

    [[nodiscard]] Vec3 to_world(const Vec3& local) const {
        return tangent * local.x + bitangent * local.y + normal * local.z;
    }
};

/// Returns (cos, sin) of 2 pi `turn` for `turn` in [0, 1], with an error below 1e-7. It has no branch and no
/// call, so that compilers vectorise a loop over it.
inline Vec2 circle_at(float turn) {
    const int quarter = static_cast<int>(4.0f * turn + 0.5f);  // the nearest quarter turn
    const float x = 2.0f * std::numbers::pi_v<float> * (turn - 0.25f * static_cast<float>(quarter));
    // Taylor series. At the largest x, pi / 4, the first omitted terms are 2e-9 and 3e-8.
    const float sq = x * x;
    const float sine =
        x * (1 - sq * (1.0f / 6) * (1 - sq * (1.0f / 20) * (1 - sq * (1.0f / 42) * (1 - sq * (1.0f / 72)))));
    const float cosine =
        1 - sq * 0.5f * (1 - sq * (1.0f / 12) * (1 - sq * (1.0f / 30) * (1 - sq * (1.0f / 56))));
    const bool odd = (quarter & 1) != 0, left = ((quarter + 1) & 2) != 0, below = (quarter & 2) != 0;
    const float across = odd ? sine : cosine, up = odd ? cosine : sine;
    return {left ? -across : across, below ? -up : up};
}

/// Returns the unit vector at polar cosine `z` and azimuth 2 pi `turn` around +z.
inline Vec3 direction_at(float z, float turn) {
    const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    const Vec2 azimuth = circle_at(turn);
    return {r * azimuth.x, r * azimuth.y, z};
}

/// Returns a direction of density cos(theta) / pi over the hemisphere around +z. Its cosine is never 0.
inline Vec3 sample_cosine_hemisphere(float u1, float u2) {
    return direction_at(std::sqrt(1.0f - u1), u2);
}

/// Returns a direction of density 1 / (4 pi) over the sphere.
inline Vec3 sample_sphere(float u1, float u2) {
    return direction_at(1.0f - 2.0f * u1, u2);
}

/// Returns a direction, uniform in solid angle over the cone of directions within `cos_angle` of +z.
inline Vec3 sample_cone(float cos_angle, float u1, float u2) {
    return direction_at(1.0f - u1 * (1.0f - cos_angle), u2);
}

/// Returns a point, uniform over the unit disc in the xy plane.
inline Vec2 sample_disc(float u1, float u2) {
    return circle_at(u2) * std::sqrt(u1);
}

/// Returns barycentric coordinates (u, v), uniform over a triangle.
inline Vec2 sample_triangle(float u1, float u2) {
    const float root = std::sqrt(u1);
    return {1.0f - root, u2 * root};
}

}  // namespace common
