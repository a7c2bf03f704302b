// The median.
#pragma once

#include <algorithm>
#include <vector>

namespace bench {

/// Returns the median; for an even number of values, the mean of the middle two. There must be at least one.
[[nodiscard]] inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

}  // namespace bench
