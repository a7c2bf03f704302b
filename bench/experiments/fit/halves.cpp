#include "bench/experiments/fit/halves.h"

#include <algorithm>
#include <cmath>

#include "common/difference/error_metrics.h"

namespace bench::fit {
namespace {

using common::Rgb;

/// Calls `work` with point, channel and weight for every value.
template <class Work>
void for_all_values(const Measure& measure, Work work) {
    for (std::size_t i = 0; i < measure.weight.size(); ++i)
        for (int c = 0; c < 3; ++c) work(i, c, double{measure.weight[i][c]});
}

double value_count(const Measure& measure) {
    return 3.0 * static_cast<double>(measure.weight.size());
}

}  // namespace

Measure::Measure(std::span<const Rgb> best, std::span<const std::uint32_t> tile_of, const Tiling& tiling_of)
    : tile(tile_of), tiling(tiling_of) {
    const double epsilon = common::relative_epsilon(best);
    weight.resize(best.size());
    for (std::size_t i = 0; i < best.size(); ++i)
        for (int c = 0; c < 3; ++c)
            weight[i][c] = static_cast<float>(1 / (double{best[i][c]} * best[i][c] + epsilon));
}

double SquareEstimate::variance() const {
    return variance_of_sum(tile_difference, tiling);
}

SquareEstimate squared_difference(const Halves& halves, const Halves& other, const Measure& measure) {
    SquareEstimate estimate{.value = 0,
                            .sampling_variance = 0,
                            .tile_difference = std::vector<double>(measure.tiling.count()),
                            .tiling = measure.tiling};
    const std::size_t points = measure.weight.size();
    double sum_of_squares = 0;  // squared contributions, less the squares of half the halves' difference
    for (std::size_t i = 0; i < points; ++i) {
        double added = 0, difference = 0;
        for (int c = 0; c < 3; ++c) {
            const double a = double{halves.a[i][c]} - other.a[i][c];
            const double b = double{halves.b[i][c]} - other.b[i][c];
            const double share = double{measure.weight[i][c]} / value_count(measure);
            added += share * a * b;
            difference += 0.5 * share * (a * a - b * b);
        }
        estimate.value += added;
        estimate.tile_difference[measure.tile[i]] += difference;
        sum_of_squares += added * added - difference * difference;
    }
    const double of_mean = estimate.value * estimate.value / static_cast<double>(points);
    estimate.sampling_variance = std::max(0.0, sum_of_squares - of_mean);
    return estimate;
}

double mean_square(std::span<const Rgb> values, const Measure& measure) {
    double sum = 0;
    for_all_values(measure,
                   [&](std::size_t i, int c, double weight) { sum += weight * values[i][c] * values[i][c]; });
    return sum / value_count(measure);
}

double noise_sq(const Halves& halves, const Measure& measure) {
    std::vector<Rgb> difference(halves.a.size());
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] = halves.a[i] - halves.b[i];
    return mean_square(difference, measure) / 2;
}

double most_noise_variance(const Halves& halves, const Measure& measure) {
    std::vector<double> tile_noise(measure.tiling.count()), tile_noise_sq(measure.tiling.count());
    for_all_values(measure, [&](std::size_t i, int c, double weight) {
        const double noise = std::sqrt(weight) * (double{halves.a[i][c]} - halves.b[i][c]);
        tile_noise[measure.tile[i]] += noise;
        tile_noise_sq[measure.tile[i]] += noise * noise / 2 / value_count(measure);
    });
    const double apart = sum_of_squares(tile_noise);
    const double joined = apart > 0 ? variance_of_sum(tile_noise, measure.tiling) / apart : 1;
    return joined * sum_of_squares(tile_noise_sq);
}

double variance_about(const Halves& halves, std::span<const Rgb> centre, const Measure& measure) {
    const std::vector<Rgb> fixed(centre.begin(), centre.end());
    return squared_difference(halves, {fixed, fixed}, measure).variance();
}

std::vector<Rgb> joined(const Halves& answers, const Halves& truth, const Measure& measure) {
    std::vector<Rgb> mean = mean_of(answers);
    const std::vector<Rgb> known = mean_of(truth);
    std::vector<double> error_sq(measure.tiling.count()), truth_noise_sq(measure.tiling.count());
    for_all_values(measure, [&](std::size_t i, int c, double weight) {
        const double a = double{mean[i][c]} - truth.a[i][c], b = double{mean[i][c]} - truth.b[i][c];
        error_sq[measure.tile[i]] += weight * a * b;
        truth_noise_sq[measure.tile[i]] += weight * (a - b) * (a - b) / 4;  // variance of the mean of both
    });
    for (std::size_t i = 0; i < mean.size(); ++i) {
        const double error = std::max(0.0, error_sq[measure.tile[i]]);
        const double noise = truth_noise_sq[measure.tile[i]];
        if (error > 0) mean[i] += static_cast<float>(error / (error + noise)) * (known[i] - mean[i]);
    }
    return mean;
}

std::vector<Rgb> mean_of(const Halves& halves) {
    std::vector<Rgb> mean(halves.a.size());
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5f * (halves.a[i] + halves.b[i]);
    return mean;
}

}  // namespace bench::fit
