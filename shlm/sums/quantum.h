// The units of a light map's integer sums.
#pragma once

#include <array>

#include "common/core/vector.h"

namespace shlm {

/// Light is summed as integers, whose sums are exact in any order. The unit is fixed for a run by its scene's
/// light, separately for each channel. It is a power of two, so that scaling by it is exact.
class Quantum {
  public:
    /// A photon carries about the power of all lights (W times the number of photons emitted) all along its
    /// path. That is 2^23 to 2^24 quanta: as fine as a float of that size.
    static constexpr int bits = 23;

    /// `power` is that of all lights, W (common::PhotonSource::power). A channel without light takes the unit
    /// of the brightest.
    explicit Quantum(const common::Rgb& power) {
        for (int c = 0; c < 3; ++c) {
            const float light = power[c] > 0 ? power[c] : common::max_component(power);
            constexpr int least = -120, most = 120;  // the unit and its inverse are normal floats
            exponents_[static_cast<std::size_t>(c)] =
                light > 0 ? std::clamp(std::ilogb(light) - bits, least, most) : -bits;
        }
    }

    /// Channel c counts in units of 2^exponents[c], W times the number of photons emitted.
    [[nodiscard]] const std::array<int, 3>& exponents() const { return exponents_; }

    [[nodiscard]] double unit(std::size_t channel) const { return std::ldexp(1.0, exponents_[channel]); }

    /// Returns the factor from a flux (common::HitBatch) to quanta.
    [[nodiscard]] common::Rgb per_flux() const {
        return {std::ldexp(1.0f, -exponents_[0]), std::ldexp(1.0f, -exponents_[1]),
                std::ldexp(1.0f, -exponents_[2])};
    }

    /// Returns the unit of ClampedLight, coarse enough for the hits of all texels together.
    [[nodiscard]] double clamped_light_unit() const {
        return std::ldexp(1.0, std::max({exponents_[0], exponents_[1], exponents_[2]}) + 4);
    }

  private:
    std::array<int, 3> exponents_{};
};

}  // namespace shlm
