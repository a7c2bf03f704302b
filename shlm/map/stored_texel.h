// A texel as the finished map stores it: floats, or half floats and a packed face.
#pragma once

#include <Imath/half.h>

#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "shlm/basis/basis.h"
#include "shlm/map/packed_normal.h"
#include "shlm/map/texel_lookup.h"

namespace shlm {

using Imath::half;

/// A TexelFace in six bytes. The unit of its area is a 65535th of the largest one's, and it is at least 1.
struct PackedFace {
    std::array<std::uint16_t, 2> normal{};
    std::uint16_t area = 0;

    PackedFace() = default;
    PackedFace(const TexelFace& face, float largest_area) {
        if (face.area == 0 || face.normal == common::Vec3(0, 0, 0)) return;  // contributes to no point
        normal = pack_normal(face.normal);
        area = static_cast<std::uint16_t>(std::max(std::lround(face.area / largest_area * 0xffff), 1l));
    }

    [[nodiscard]] TexelFace unpacked() const {
        return {unpack_normal(normal[0], normal[1]), static_cast<float>(area)};
    }
};

/// A texel that a gather can find. `Number`: float or half.
template <Basis B, class Number = float>
struct Texel {
    static constexpr std::size_t count = number_count<B>;

    std::conditional_t<std::is_same_v<Number, float>, TexelFace, PackedFace> face;
    std::array<Number, count> stored;

    /// Returns the numbers. Those of light are in the map's unit (LightMap::unit).
    [[nodiscard]] typename B::Numbers numbers() const {
        typename B::Numbers numbers;
        for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<float>(stored[i]);
        return numbers;
    }

    /// Returns irradiance for a shading normal, in the map's unit; may be negative.
    [[nodiscard]] common::Rgb irradiance(const common::Vec3& shading_normal) const {
        return B::irradiance(numbers(), face.unpacked().normal, typename B::Question(shading_normal));
    }
};

/// Returns a unit for halves, W/m^2, a power of two. It is so large that no coefficient of light exceeds the
/// range of a half. Halves have 40 binary orders of magnitude, so that 4e-9 of the brightest still has all 11
/// bits. `largest` is the largest magnitude of the coefficients.
[[nodiscard]] inline float unit_for_halves(float largest) {
    if (largest == 0) return 1;
    constexpr int largest_exponent = 15;  // 2^15 <= 65504
    return std::ldexp(1.0f, std::max(std::ilogb(largest) + 1 - largest_exponent, -120));
}
template <Basis B>
[[nodiscard]] float unit_for_halves(std::span<const Texel<B>> texels) {
    float largest = 0;
    for (const Texel<B>& texel : texels)
        for (std::size_t i = 0; i < B::light_numbers; ++i)
            largest = std::max(largest, std::abs(texel.stored[i]));
    return unit_for_halves(largest);
}

/// Returns the nearest half, clamped to the largest one.
[[nodiscard]] inline half half_of(float number, float unit) {
    constexpr float largest = 65504;
    return half(std::clamp(number / unit, -largest, largest));
}

/// Converts a texel to halves. `unit` is that of the numbers; `largest_area` is that of all texels of the
/// map.
template <Basis B>
[[nodiscard]] Texel<B, half> in_halves(const Texel<B>& texel, float unit, float largest_area) {
    Texel<B, half> result{{texel.face, largest_area}, {}};
    for (std::size_t i = 0; i < result.stored.size(); ++i)
        result.stored[i] = half_of(texel.stored[i], i < B::light_numbers ? unit : 1);
    return result;
}

}  // namespace shlm
