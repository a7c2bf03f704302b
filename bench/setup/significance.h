// Bounds for random quantities, from a declared chance of failing by accident.
#pragma once

#include <cmath>
#include <numbers>

namespace bench {

/// How many standard deviations a normal variable exceeds, to either side, with probability `alpha`.
inline double z_for(double alpha) {
    double low = 0, high = 40;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > alpha ? low : high) = middle;
    }
    return high;
}

/// Probability that Student's t with so many degrees of freedom exceeds `t` to either side (Abramowitz and
/// Stegun 1964, 26.7.3 and 26.7.4).
inline double student_tail(double t, int degrees_of_freedom) {
    const double angle = std::atan(t / std::sqrt(degrees_of_freedom)), cosine = std::cos(angle);
    const bool odd = degrees_of_freedom % 2 == 1;
    double sum = 0, term = odd ? cosine : 1;
    for (int k = odd ? 1 : 0; k < degrees_of_freedom; k += 2) {
        sum += term;
        term *= cosine * cosine * (k + 1) / (k + 2);
    }
    const double inside = std::sin(angle) * sum;
    return odd ? 1 - 2 / std::numbers::pi * (angle + inside) : 1 - inside;
}

/// How many standard deviations, estimated from one value more than there are degrees of freedom, a normal
/// variable exceeds, to either side, with probability `alpha`.
inline double t_for(double alpha, int degrees_of_freedom) {
    double low = 0, high = 1e6;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (student_tail(middle, degrees_of_freedom) > alpha ? low : high) = middle;
    }
    return high;
}

}  // namespace bench
