#include "bench/experiments/fit/halves.h"

#include <cmath>

#include "common/difference/error_metrics.h"

namespace bench::fit {
namespace {

using common::Rgb;

/// Calls `work` with point, channel and weight.
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

double SquareEstimate::standard_error() const {
    return std::sqrt(variance());
}

SquareEstimate& SquareEstimate::operator+=(const SquareEstimate& other) {
    value += other.value;
    if (!other.tile_difference.empty()) tiling = other.tiling;
    tile_difference.resize(std::max(tile_difference.size(), other.tile_difference.size()));
    for (std::size_t t = 0; t < other.tile_difference.size(); ++t)
        tile_difference[t] += other.tile_difference[t];
    return *this;
}

SquareEstimate SquareEstimate::scaled(double factor) const {
    SquareEstimate result = *this;
    result.value *= factor;
    for (double& difference : result.tile_difference) difference *= factor;
    return result;
}

SquareEstimate squared_difference(const Halves& halves, const Halves& other, const Measure& measure) {
    SquareEstimate estimate{
        .value = 0, .tile_difference = std::vector<double>(measure.tiling.count()), .tiling = measure.tiling};
    for_all_values(measure, [&](std::size_t i, int c, double weight) {
        const double a = double{halves.a[i][c]} - other.a[i][c], b = double{halves.b[i][c]} - other.b[i][c];
        estimate.value += weight * a * b;
        estimate.tile_difference[measure.tile[i]] += 0.5 * weight * (a * a - b * b);
    });
    return estimate.scaled(1 / value_count(measure));
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

std::vector<Rgb> mean_of(const Halves& halves) {
    std::vector<Rgb> mean(halves.a.size());
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5f * (halves.a[i] + halves.b[i]);
    return mean;
}

}  // namespace bench::fit
