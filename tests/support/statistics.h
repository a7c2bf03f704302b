// Bounds for random quantities with a declared false alarm probability.
#pragma once

#include <cmath>
#include <cstdint>

#include "bench/setup/significance.h"

namespace tests {

/// Returns the first number in an optimised build, the second one where every sample is slow: without
/// optimisation or under a sanitizer.
constexpr std::uint64_t count_for(std::uint64_t optimised, std::uint64_t slow) {
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    (void)slow;
    return optimised;
#else
    (void)optimised;
    return slow;
#endif
}

using bench::student_tail;
using bench::t_for;
using bench::z_for;

/// Returns the probability that a chi-square variable exceeds `x`. For an even number 2 n of degrees of
/// freedom, this is the probability of fewer than n Poisson events of mean x / 2.
inline double chi_square_tail(double x, int even_degrees_of_freedom) {
    const double mean = 0.5 * x;
    double sum = 0;
    for (int i = 0; i < even_degrees_of_freedom / 2; ++i)
        sum += std::exp(-mean + i * std::log(mean) - std::lgamma(i + 1.0));
    return mean > 0 ? sum : 1.0;
}

/// Returns the chi-square statistic of counts against expected counts.
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

/// Mean, variance and standard error of independent values.
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
