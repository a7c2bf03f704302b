// Random numbers of the reference. They are independent of the photon tracer's, so that comparing the two
// shows an error of either.
#pragma once

#include <Random123/threefry.h>

#include <array>
#include <cstdint>

namespace common::reference {

/// The sequence of random numbers of one sample of one pixel: Threefry4x32-20 (Salmon et al., "Parallel
/// Random Numbers: As Easy as 1, 2, 3", 2011). The key is the seed; the counter is the pixel, pass, sample
/// and block of four numbers.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::uint32_t pixel, std::uint32_t pass, std::uint32_t sample)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), 0, 0}},
          counter_{{pixel, pass, sample, 0}} {}

    /// Returns a uniform number in (0, 1), never 0 or 1: a multiple of 2^-33.
    double next() {
        if (used_ == 4) {
            bits_ = r123::Threefry4x32{}(counter_, key_);
            ++counter_[3];
            used_ = 0;
        }
        return (static_cast<double>(bits_[used_++]) + 0.5) * 0x1p-32;
    }

  private:
    r123::Threefry4x32::key_type key_;
    r123::Threefry4x32::ctr_type counter_;
    r123::Threefry4x32::ctr_type bits_{};
    unsigned used_ = 4;
};

}  // namespace common::reference
