// Predicts the rounding of a long sum in a float.
#pragma once

#include <algorithm>
#include <cmath>

namespace bench::stability {

/// Predicts the float sum of `count` values, each added to the sum so far. Between two powers of two, floats
/// are one step apart. An add changes the sum by `value` rounded to whole steps, ties to even. So it adds
/// more or less than `value`, and nothing once a step is over twice as long. The result is exact to one step
/// per octave.
[[nodiscard]] inline double float_sum_of_equal_adds(float value, double count) {
    double sum = value, left = count - 1;
    while (left > 0) {
        const double end_of_octave = std::ldexp(1.0, std::ilogb(sum) + 1), step = end_of_octave * 0x1p-24;
        const double move = std::rint(value / step) * step;
        if (move == 0) break;
        const double adds = std::min(left, std::ceil((end_of_octave - sum) / move));
        sum += adds * move;
        left -= adds;
    }
    return sum;
}

/// Error bound of float_sum_of_equal_adds, relative: a step of 2^-23 in each of the last octaves, which add
/// up as 1 + 1/2 + 1/4...
inline constexpr double allowed_of_float_sum = 0x1p-22;

}  // namespace bench::stability
