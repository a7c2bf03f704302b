// Bounds for random quantities, from a declared chance of failing by accident.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace tests {

/// The larger number in an optimised build, the smaller one where every sample is slow: without optimisation
/// or under a sanitizer.
constexpr std::uint64_t count_for(std::uint64_t optimised, std::uint64_t slow) {
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    (void)slow;
    return optimised;
#else
    (void)optimised;
    return slow;
#endif
}

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

/// Probability that a chi-square variable exceeds `x`. For an even number of degrees of freedom 2 n this is
/// the probability of fewer than n Poisson events of mean x / 2.
inline double chi_square_tail(double x, int even_degrees_of_freedom) {
    const double mean = 0.5 * x;
    double sum = 0;
    for (int i = 0; i < even_degrees_of_freedom / 2; ++i)
        sum += std::exp(-mean + i * std::log(mean) - std::lgamma(i + 1.0));
    return mean > 0 ? sum : 1.0;
}

/// Chi-square statistic of counts against expected counts.
template <class Counts, class Expected>
double chi_square(const Counts& counts, const Expected& expected) {
    double sum = 0;
    auto e = std::begin(expected);
    for (auto count : counts) {
        const double difference = static_cast<double>(count) - *e;
        sum += difference * difference / *e++;
    }
    return sum;
}

/// Mean, spread and standard error of independent values.
class Sample {
  public:
    void add(double value) {
        ++count_;
        const double step = value - mean_;
        mean_ += step / static_cast<double>(count_);
        squares_ += step * (value - mean_);
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double variance() const { return squares_ / static_cast<double>(count_ - 1); }
    [[nodiscard]] double standard_error() const {
        return std::sqrt(variance() / static_cast<double>(count_));
    }

  private:
    std::uint64_t count_ = 0;
    double mean_ = 0, squares_ = 0;
};

}  // namespace tests
