// Hits that a store could not take.
#pragma once

#include <cstdint>

namespace common {

/// Hits that a store could not take, by reason. Hits of a run = stored + rejected.
struct RejectedHits {
    std::uint64_t not_finite = 0;            ///< position, direction or flux is NaN or infinite
    std::uint64_t without_texel = 0;         ///< the surface has no texels
    std::uint64_t back_of_single_sided = 0;  ///< on the back of a surface whose material shows its front only
    std::uint64_t outside_texels = 0;        ///< rounding put it on a texel that no triangle covers

    [[nodiscard]] std::uint64_t total() const {
        return not_finite + without_texel + back_of_single_sided + outside_texels;
    }

    RejectedHits& operator+=(const RejectedHits& other) {
        not_finite += other.not_finite;
        without_texel += other.without_texel;
        back_of_single_sided += other.back_of_single_sided;
        outside_texels += other.outside_texels;
        return *this;
    }
};

}  // namespace common
