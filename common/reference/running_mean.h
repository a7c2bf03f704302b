// Mean of independent values that can be stored in floats and continued exactly.
#pragma once

#include <cstdint>

namespace common::reference {

/// A double of at most 48 significant bits, as the sum of two floats.
struct FloatPair {
    float high = 0;
    float low = 0;  ///< the rounding error of `high`

    [[nodiscard]] double value() const { return static_cast<double>(high) + static_cast<double>(low); }
};

[[nodiscard]] inline FloatPair rounded_pair(double value) {
    const auto high = static_cast<float>(value);
    return {high, static_cast<float>(value - static_cast<double>(high))};
}

/// Mean of the values so far and the variance of that mean, by Welford's recurrence ("Note on a Method for
/// Calculating Corrected Sums of Squares and Products", 1962) in double. After every step both are rounded to
/// what a file of floats can hold. So a run that is stored and continued gives the same result as one without
/// a stop.
class RunningMean {
  public:
    RunningMean() = default;
    RunningMean(const FloatPair& mean, const FloatPair& variance) : mean_(mean), variance_(variance) {}

    /// Adds a value; `count` values were added before it.
    void add(double value, std::uint64_t count) {
        const auto before = static_cast<double>(count), after = before + 1;
        const double step = value - mean_.value();
        const double mean = mean_.value() + step / after;
        if (count > 0) {
            const double squares = variance_.value() * before * (before - 1) + step * (value - mean);
            variance_ = rounded_pair(squares / (after * before));
        }
        mean_ = rounded_pair(mean);
    }

    [[nodiscard]] const FloatPair& mean() const { return mean_; }
    [[nodiscard]] const FloatPair& variance() const { return variance_; }  ///< of the mean; 0 for one value

  private:
    FloatPair mean_, variance_;
};

}  // namespace common::reference
