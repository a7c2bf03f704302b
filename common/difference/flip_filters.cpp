#include "common/difference/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace common {
namespace {

constexpr double pi = std::numbers::pi;

/// sqrt(pi / b) amplitude exp(-pi^2 x^2 / b) at x degrees from the middle.
struct Gaussian {
    double amplitude, b;
};

// Andersson et al. 2020, section 4.1: fits to the measured contrast sensitivity of the eye.
constexpr Gaussian black_white = {1, 0.0047};
constexpr Gaussian red_green = {1, 0.0053};
constexpr Gaussian blue_yellow_wide = {34.1, 0.04};
constexpr Gaussian blue_yellow_narrow = {13.5, 0.025};

/// Returns three standard deviations of the widest Gaussian, in pixels; all filters have this radius.
int contrast_radius(double pixels_per_degree) {
    return static_cast<int>(std::ceil(3 * std::sqrt(blue_yellow_wide.b / (2 * pi * pi)) * pixels_per_degree));
}

template <class Function>
std::vector<double> sampled(int radius, Function function) {
    std::vector<double> values;
    for (int i = -radius; i <= radius; ++i) values.push_back(function(static_cast<double>(i)));
    return values;
}

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

Kernel scaled(const std::vector<double>& values, double positive, double negative) {
    Kernel kernel;
    for (const double value : values)
        kernel.weights.push_back(static_cast<float>(value * (value > 0 ? positive : negative)));
    return kernel;
}

Kernel normalised(const std::vector<double>& values) {
    const double scale = 1 / sum_of(values);
    return scaled(values, scale, scale);
}

/// Scales positive and negative values each to a sum of 1.
Kernel balanced(const std::vector<double>& values) {
    double positive = 0, negative = 0;
    for (const double value : values) (value > 0 ? positive : negative) += std::abs(value);
    return scaled(values, 1 / positive, 1 / negative);
}

std::vector<double> sampled(const Gaussian& gaussian, double pixels_per_degree) {
    return sampled(contrast_radius(pixels_per_degree), [&](double pixels) {
        const double x = pixels / pixels_per_degree;
        return std::exp(-pi * pi * x * x / gaussian.b);
    });
}

/// Returns the sum of a Gaussian over the square of pixels, its weight in a sum of several.
double mass(const Gaussian& gaussian, const std::vector<double>& samples) {
    return gaussian.amplitude * std::sqrt(pi / gaussian.b) * sum_of(samples) * sum_of(samples);
}

}  // namespace

ContrastFilters contrast_filters(float pixels_per_degree) {
    const auto narrow = sampled(blue_yellow_narrow, pixels_per_degree);
    const auto wide = sampled(blue_yellow_wide, pixels_per_degree);
    const double narrow_mass = mass(blue_yellow_narrow, narrow), wide_mass = mass(blue_yellow_wide, wide);
    const double both = narrow_mass + wide_mass;
    return {{1, normalised(sampled(black_white, pixels_per_degree))},
            {1, normalised(sampled(red_green, pixels_per_degree))},
            {static_cast<float>(narrow_mass / both), normalised(narrow)},
            {static_cast<float>(wide_mass / both), normalised(wide)}};
}

FeatureFilters feature_filters(float pixels_per_degree) {
    constexpr double width = 0.082;  // degrees, from peak to trough, of the features that the eye detects
                                     // best
    const double deviation = 0.5 * width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
    return {normalised(sampled(radius, gaussian)),
            balanced(sampled(radius, [&](double x) { return -x * gaussian(x); })),
            balanced(sampled(radius,
                             [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }))};
}

}  // namespace common
