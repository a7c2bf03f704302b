// Compact encoding of unit vectors.
#pragma once

#include <cstdint>

#include "common/core/vector.h"

namespace common {

/// Encodes unit vectors as points of an octahedron unfolded into a square (Cigolle et al. 2014, "A Survey of
/// Efficient Representations for Independent Unit Vectors"). Each coordinate has 2^Bits - 1 equally spaced
/// values. The axes, and all vectors whose coordinates are multiples of the spacing, are exact. The decoded
/// vector is within sqrt(4.5) / (2^(Bits - 1) - 1) radians of the original.
template <int Bits>
struct Octahedral {
    static constexpr int half_steps = (1 << (Bits - 1)) - 1;
    static constexpr std::uint32_t mask = (1u << Bits) - 1;

    [[nodiscard]] static std::uint32_t pack(const Vec3& v) {
        const float to_octahedron = 1 / (std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
        float s = v.x * to_octahedron, t = v.y * to_octahedron;
        if (v.z < 0) {
            const float folded_s = std::copysign(1 - std::abs(t), s);
            t = std::copysign(1 - std::abs(s), t);
            s = folded_s;
        }
        return step(s) | step(t) << Bits;
    }

    /// Returns a unit vector.
    [[nodiscard]] static Vec3 unpack(std::uint32_t packed) {
        Vec3 v(value(packed & mask), value(packed >> Bits & mask), 0);
        v.z = 1 - std::abs(v.x) - std::abs(v.y);
        const float below = std::max(-v.z, 0.0f);
        v.x -= std::copysign(below, v.x);
        v.y -= std::copysign(below, v.y);
        return v * (1 / std::sqrt(v.dot(v)));
    }

  private:
    static std::uint32_t step(float s) {
        return static_cast<std::uint32_t>(s * half_steps + (half_steps + 0.5f));
    }
    static float value(std::uint32_t step) {
        return static_cast<float>(static_cast<int>(step) - half_steps) * (1.0f / half_steps);
    }
};

}  // namespace common
