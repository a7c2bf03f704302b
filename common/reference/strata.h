// Stratified first random numbers of a pass's samples.
#pragma once

#include <array>

#include "common/reference/random_stream.h"

namespace common::reference {

inline constexpr std::uint32_t samples_per_pass = 64;

/// The random numbers that a sample uses at the visible point itself.
struct FirstNumbers {
    std::array<double, 2> direction;  ///< in (0, 1), as all of these
    std::array<double, 2> on_light;
    double which_light;
};

/// Stratifies the first numbers of the samples of one pass of one pixel. Directions and places on lights are
/// jittered in 8 x 8 cells, the choice of a light in 64 intervals. Cells are paired at random (McKay et al.,
/// "A Comparison of Three Methods for Selecting Values of Input Variables", 1979). Each sample alone is
/// uniform, and passes are independent of each other.
class PassStrata {
  public:
    PassStrata(std::uint64_t seed, std::uint32_t pixel, std::uint32_t pass);

    /// Returns the numbers of sample `sample` < samples_per_pass; the jitter comes from `stream`.
    [[nodiscard]] FirstNumbers numbers(std::uint32_t sample, RandomStream& stream) const;

  private:
    using Permutation = std::array<std::uint8_t, samples_per_pass>;

    Permutation on_light_, which_light_;
};

}  // namespace common::reference
