// A unit vector in four bytes.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "common/core/vector.h"

namespace shlm {

/// Laid out on an octahedron and rounded to 16 bits twice: within 0.004 degrees (Cigolle et al., "A Survey of
/// Efficient Representations for Independent Unit Vectors", JCGT 2014).
[[nodiscard]] inline std::array<std::uint16_t, 2> pack_normal(const common::Vec3& n) {
    const float scale = 1 / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    float x = n.x * scale, y = n.y * scale;
    if (n.z < 0) {
        const float folded_x = (1 - std::abs(y)) * std::copysign(1.0f, x);
        y = (1 - std::abs(x)) * std::copysign(1.0f, y);
        x = folded_x;
    }
    const auto packed = [](float v) { return static_cast<std::uint16_t>(std::lround(v * 32767) + 32767); };
    return {packed(x), packed(y)};
}

[[nodiscard]] inline common::Vec3 unpack_normal(std::uint16_t packed_x, std::uint16_t packed_y) {
    const auto unpacked = [](std::uint16_t v) { return (static_cast<float>(v) - 32767) / 32767; };
    float x = unpacked(packed_x), y = unpacked(packed_y);
    const float z = 1 - std::abs(x) - std::abs(y);
    if (z < 0) {
        const float folded_x = (1 - std::abs(y)) * std::copysign(1.0f, x);
        y = (1 - std::abs(x)) * std::copysign(1.0f, y);
        x = folded_x;
    }
    return common::Vec3(x, y, z).normalized();
}

}  // namespace shlm
