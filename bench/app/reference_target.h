// When a reference is good enough.
#pragma once

#include <cstdint>
#include <string>

namespace bench {

/// A variance takes two passes; with less there is no image.
inline constexpr std::uint64_t fewest_passes = 2;

/// One of the two is asked for, the other is 0.
struct ReferenceTarget {
    std::uint64_t passes = 0;
    double relative_error = 0;  ///< see common::reference::relative_error()

    /// Passes after which the error is looked at, counted from the first so that a run which was stopped and
    /// taken up again ends where it would have ended anyway.
    static constexpr std::uint64_t passes_between_looks = 8;

    [[nodiscard]] bool reached(std::uint64_t passes_done, double error) const;

    /// How many passes there will be in all, as far as one can tell.
    [[nodiscard]] std::uint64_t expected_passes(std::uint64_t passes_done, double error) const;
};

/// From the texts of --spp and --until; both empty: 1024 samples per pixel. Throws InputError where both are
/// given or one means nothing.
[[nodiscard]] ReferenceTarget reference_target(const std::string& spp, const std::string& until);

}  // namespace bench
