// Tiles of the image, whose sums tell the variance of the sum over the whole image.
#pragma once

#include <cstdint>
#include <span>

namespace bench::fit {

struct Tiling {
    std::uint32_t across = 0, down = 0;  ///< row by row

    [[nodiscard]] std::uint32_t count() const { return across * down; }
};

[[nodiscard]] double sum_of_squares(std::span<const double> values);

/// Estimates the variance of the sum of all tiles' values, each of which has expectation zero. For
/// independent tiles it is the sum of their squares. The noise of coarse maps is correlated between tiles,
/// which shows when tiles are joined. So this is the largest of the estimates by single tiles, by 2 x 2 and
/// by 4 x 4 of them. For independent tiles it is slightly too large: 1.2 times the variance on average for 16
/// x 9 normal variables.
[[nodiscard]] double variance_of_sum(std::span<const double> values, const Tiling& tiling);

}  // namespace bench::fit
