// When a reference is good enough.
#pragma once

#include <cstdint>
#include <string>

namespace bench {

/// A variance takes two passes; with less there is no image.
inline constexpr std::uint64_t fewest_passes = 2;

/// One of the two is set, the other is 0.
struct ReferenceTarget {
    std::uint64_t passes = 0;
    double relative_error = 0;  ///< see common::reference::relative_error()

    /// The error is checked after so many passes. They are counted from the first pass, so that a run that
    /// was stopped and continued ends where it would have ended anyway.
    static constexpr std::uint64_t passes_between_looks = 8;

    [[nodiscard]] bool reached(std::uint64_t passes_done, double error) const;

    /// Returns the estimated total number of passes.
    [[nodiscard]] std::uint64_t expected_passes(std::uint64_t passes_done, double error) const;
};

/// Parses --spp and --until; if both are empty, the target is 1024 samples per pixel. Throws InputError if
/// both are given or one is invalid.
[[nodiscard]] ReferenceTarget reference_target(const std::string& spp, const std::string& until);

}  // namespace bench
