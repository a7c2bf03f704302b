// Random numbers of the reference, which shares none with the photon tracer: an error of one would be seen by
// the other.
#pragma once

#include <Random123/threefry.h>

#include <array>
#include <cstdint>

namespace common::reference {

/// The numbers of one sample of one pixel, one after the other: Threefry4x32-20 (Salmon et al., "Parallel
/// Random Numbers: As Easy as 1, 2, 3", 2011), keyed by the seed and counted by pixel, pass, sample and block
/// of four.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::uint32_t pixel, std::uint32_t pass, std::uint32_t sample)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), 0, 0}},
          counter_{{pixel, pass, sample, 0}} {}

    /// Uniform in (0, 1), never an end of it: a multiple of 2^-33.
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
