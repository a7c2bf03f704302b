// What a float makes of a long sum.
#pragma once

#include <algorithm>
#include <cmath>

namespace bench::stability {

/// A float's sum of `count` times `value`, each added to what is there. Between two powers of two floats are
/// one step apart, and an add moves the sum by `value` rounded to whole steps, a half to even ones: by more
/// or less than `value`, and by nothing once a step is twice as long. Right to a step for each octave.
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

/// How far off that may be of itself: a step, 2^-23, in each of the last few octaves, which add up as 1 + 1/2
/// + 1/4...
inline constexpr double allowed_of_float_sum = 0x1p-22;

}  // namespace bench::stability
