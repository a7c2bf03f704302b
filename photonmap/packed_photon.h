// A photon in 24 bytes: the position is exact, what is summed is rounded.
#pragma once

#include <bit>
#include <cstdint>

#include "common/core/octahedral.h"

namespace photonmap {

/// Three numbers >= 0 of ten bits each, with the exponent of the largest (Ward 1991, "Real Pixels", with two
/// bits more). Each is within 2^-10 of the largest. 38 bits.
struct SharedExponent {
    [[nodiscard]] static std::uint64_t pack(const common::Rgb& c) {
        constexpr float largest_finite = 3e38f, smallest = 0x1p-116f;
        const float largest = std::min(common::max_component(c), largest_finite);
        if (!(largest >= smallest)) return 0;
        // The scale is a power of two that brings the largest to the range from 512 to 1024, or to 512 if it
        // would be rounded up to 1024.
        std::uint32_t exponent = (std::bit_cast<std::uint32_t>(largest) >> 23) - 9;
        if (largest / scale(exponent) >= 1023.5f) ++exponent;
        const auto rounded = [&](float x) {
            return static_cast<std::uint64_t>(std::min(x, largest_finite) / scale(exponent) + 0.5f);
        };
        return rounded(c.x) | rounded(c.y) << 10 | rounded(c.z) << 20 | std::uint64_t{exponent} << 30;
    }

    [[nodiscard]] static common::Rgb unpack(std::uint64_t packed) {
        const auto bits = [&](int first) { return static_cast<float>(packed >> first & 0x3ff); };
        return common::Rgb(bits(0), bits(10), bits(20)) *
               scale(static_cast<std::uint32_t>(packed >> 30 & 0xff));
    }

  private:
    static float scale(std::uint32_t exponent) { return std::bit_cast<float>(exponent << 23); }
};

/// The contribution of one photon: its flux on a plane that faces it, and its direction of travel. 38 and 26
/// bits.
///
/// The flux is divided by the cosine of incidence before it is rounded. So a gather needs no normal for the
/// sum, and a rounded normal cannot give a grazing photon a wrong weight.
struct PackedLight {
    std::uint64_t bits;

    using Direction = common::Octahedral<13>;

    [[nodiscard]] static PackedLight pack(const common::Vec3& direction, const common::Rgb& facing_flux) {
        return {SharedExponent::pack(facing_flux) | std::uint64_t{Direction::pack(direction)} << 38};
    }
    [[nodiscard]] common::Rgb facing_flux() const { return SharedExponent::unpack(bits); }
    [[nodiscard]] common::Vec3 direction() const {
        return Direction::unpack(static_cast<std::uint32_t>(bits >> 38));
    }
};

/// The normal of the photon's surface, on the side of arrival. It only decides whether a photon counts: 16
/// bits, within a degree.
using PackedNormal = common::Octahedral<8>;

/// A photon as stored during tracing: later only the boxes of the index are added.
struct PackedPhoton {
    common::Vec3 position;
    std::uint16_t arrival_normal;
    PackedLight light;
};
static_assert(sizeof(PackedPhoton) == 24);

}  // namespace photonmap
