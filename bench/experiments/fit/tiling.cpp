#include "bench/experiments/fit/tiling.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace bench::fit {

double sum_of_squares(std::span<const double> values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

double variance_of_sum(std::span<const double> values, const Tiling& tiling) {
    double largest = 0;
    for (const std::uint32_t side : {1u, 2u, 4u}) {
        const std::uint32_t across = (tiling.across + side - 1) / side;
        const std::uint32_t down = (tiling.down + side - 1) / side;
        std::vector<double> joined(std::size_t{across} * down);
        for (std::uint32_t y = 0; y < tiling.down; ++y)
            for (std::uint32_t x = 0; x < tiling.across; ++x)
                joined[y / side * across + x / side] += values[y * tiling.across + x];
        largest = std::max(largest, sum_of_squares(joined));
    }
    return largest;
}

}  // namespace bench::fit
