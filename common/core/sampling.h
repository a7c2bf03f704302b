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

/// Unit vector at polar cosine `z` and azimuth 2 pi `turn` around +z.
inline Vec3 direction_at(float z, float turn) {
    const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    const float phi = 2.0f * std::numbers::pi_v<float> * turn;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Density cos(theta) / pi over the hemisphere around +z. The cosine is never 0.
inline Vec3 sample_cosine_hemisphere(float u1, float u2) {
    return direction_at(std::sqrt(1.0f - u1), u2);
}

/// Density 1 / (4 pi).
inline Vec3 sample_sphere(float u1, float u2) {
    return direction_at(1.0f - 2.0f * u1, u2);
}

/// Uniform in solid angle over the cone of directions within `cos_angle` of +z.
inline Vec3 sample_cone(float cos_angle, float u1, float u2) {
    return direction_at(1.0f - u1 * (1.0f - cos_angle), u2);
}

/// Uniform over the unit disc in the xy plane.
inline Vec2 sample_disc(float u1, float u2) {
    const float r = std::sqrt(u1);
    const float phi = 2.0f * std::numbers::pi_v<float> * u2;
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// Barycentric (u, v), uniform over a triangle.
inline Vec2 sample_triangle(float u1, float u2) {
    const float root = std::sqrt(u1);
    return {1.0f - root, u2 * root};
}

}  // namespace common
