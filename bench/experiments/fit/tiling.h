// The parts of the image by whose sums one knows how much the whole varies.
#pragma once

#include <cstdint>
#include <span>

namespace bench::fit {

struct Tiling {
    std::uint32_t across = 0, down = 0;  ///< row by row

    [[nodiscard]] std::uint32_t count() const { return across * down; }
};

[[nodiscard]] double sum_of_squares(std::span<const double> values);

/// Variance of the sum of all tiles' values, each of which is zero in the mean: the sum of their squares
/// where they are independent. Coarse maps have noise that tiles share, which shows when tiles are joined:
/// the largest by single tiles, 2 x 2 and 4 x 4 of them. Of independent ones that is a little too much: of 16
/// x 9 normal ones 1.2 times the variance in the mean.
[[nodiscard]] double variance_of_sum(std::span<const double> values, const Tiling& tiling);

}  // namespace bench::fit
