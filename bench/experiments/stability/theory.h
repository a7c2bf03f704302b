// Formulas for the predictions of several cases.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace bench::stability {

/// Returns the fraction of a disc that lies beyond a straight line at `t` radii from its centre. For t < 0
/// the centre is beyond the line too.
[[nodiscard]] inline double segment_of_disc(double t) {
    if (t >= 1) return 0;
    if (t <= -1) return 1;
    return (std::acos(t) - t * std::sqrt(1 - t * t)) / std::numbers::pi;
}

/// Returns what a texel of `order` 1, 2 or 4 gives for a normal at cosine `x` to a single light of 1 W/m^2.
/// It is the truncated series of max(0, x) = sum of (2 l + 1) / 2 P_l(x) times the integral of y P_l(y) over
/// y from 0 to 1, which is 1/4 + 1/2 P_1 + 5/16 P_2 - 3/32 P_4 + ...
[[nodiscard]] inline double clamped_cosine_series(int order, double x) {
    double sum = 1.0 / 4 + x / 2;
    if (order >= 2) sum += 5.0 / 16 * (3 * x * x - 1) / 2;
    if (order >= 4) sum -= 3.0 / 32 * (35 * x * x * x * x - 30 * x * x + 3) / 8;
    return sum;
}

/// Returns the mean of `value(i, j)` over the four integer points nearest to (x, y). Centres of texels are
/// such points, in units of their width.
template <class Value>
[[nodiscard]] double mean_of_four_nearest(double x, double y, Value value) {
    std::array<std::pair<double, double>, 9>
        near;  // squared distance and value; no other place can be nearer
    std::size_t next = 0;
    for (double j : {-1.0, 0.0, 1.0})
        for (double i : {-1.0, 0.0, 1.0}) {
            const double column = std::round(x) + i, row = std::round(y) + j;
            near[next++] = {(column - x) * (column - x) + (row - y) * (row - y), value(column, row)};
        }
    std::partial_sort(near.begin(), near.begin() + 4, near.end());
    return (near[0].second + near[1].second + near[2].second + near[3].second) / 4;
}

}  // namespace bench::stability
