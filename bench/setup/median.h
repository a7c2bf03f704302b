// The middle of some values.
#pragma once

#include <algorithm>
#include <vector>

namespace bench {

/// The mean of the middle two where there is an even number of them. There must be one.
[[nodiscard]] inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

}  // namespace bench
