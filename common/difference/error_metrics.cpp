#include "common/difference/error_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "common/core/input_error.h"

namespace common {
namespace {

double mean_of(std::span<const Rgb> pixels) {
    double sum = 0;
    for (const Rgb& pixel : pixels) sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
    return sum / (3.0 * static_cast<double>(pixels.size()));
}

/// Mean of function(I, R) over pixels and channels.
template <class Function>
double mean_of(std::span<const Rgb> image, std::span<const Rgb> reference, Function function) {
    double sum = 0;
    for (std::size_t p = 0; p < image.size(); ++p)
        for (int c = 0; c < 3; ++c) sum += function(double{image[p][c]}, double{reference[p][c]});
    return sum / (3.0 * static_cast<double>(image.size()));
}

/// Returns three errors per pixel.
std::vector<double> relative_errors(std::span<const Rgb> image, std::span<const Rgb> reference,
                                    double epsilon) {
    std::vector<double> errors;
    errors.reserve(3 * image.size());
    for (std::size_t p = 0; p < image.size(); ++p)
        for (int c = 0; c < 3; ++c) {
            const double i = image[p][c], r = reference[p][c];
            errors.push_back(std::abs(i - r) / std::sqrt(r * r + epsilon));
        }
    return errors;
}

/// Returns the smallest value that at least the fraction `share` of all values does not exceed.
double quantile(std::vector<double> values, double share) {
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
    const auto at = values.begin() + rank - 1;
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Returns the share of the sum of squared errors in the thousandth of pixels, at least one, with the
/// largest. `errors` has three values per pixel.
double share_of_worst(std::span<const double> errors) {
    std::vector<double> square(errors.size() / 3);
    for (std::size_t p = 0; p < square.size(); ++p)
        for (const double error : errors.subspan(3 * p, 3)) square[p] += error * error;
    std::sort(square.begin(), square.end());
    const double all = std::accumulate(square.begin(), square.end(), 0.0);
    const auto worst = static_cast<std::ptrdiff_t>(std::ceil(0.001 * static_cast<double>(square.size())));
    return all > 0 ? std::accumulate(square.end() - worst, square.end(), 0.0) / all : 0;
}

void check_pixels(std::span<const Rgb> image, std::span<const Rgb> reference) {
    if (image.size() != reference.size() || image.empty())
        throw InputError(
            fmt::format("difference: {} pixels cannot be compared with {}", image.size(), reference.size()));
    for (std::size_t p = 0; p < image.size(); ++p)
        if (!is_finite(image[p]) || !is_finite(reference[p]))
            throw InputError(fmt::format("difference: pixel {} is not finite", p));
}

}  // namespace

float relative_epsilon(std::span<const Rgb> reference) {
    using Limits = std::numeric_limits<float>;
    const double mean = mean_of(reference);
    const double epsilon = 0.01 * mean * mean;
    if (!(epsilon >= Limits::min() && epsilon <= Limits::max()))
        throw InputError(
            fmt::format("the mean of the reference is {:g}: no error can be relative to it", mean));
    return static_cast<float>(epsilon);
}

DifferenceFigures difference(std::span<const Rgb> image, std::span<const Rgb> reference) {
    check_pixels(image, reference);
    const double epsilon = relative_epsilon(reference), root = std::sqrt(epsilon);
    const double mean_image = mean_of(image), mean_reference = mean_of(reference);
    const double relmse =
        mean_of(image, reference, [&](double i, double r) { return (i - r) * (i - r) / (r * r + epsilon); });
    const double mse = mean_of(image, reference, [](double i, double r) { return (i - r) * (i - r); });
    const double smape = mean_of(image, reference, [&](double i, double r) {
        return 2 * std::abs(i - r) / (std::abs(i) + std::abs(r) + root);
    });
    const std::vector<double> errors = relative_errors(image, reference, epsilon);
    const auto worst = std::max_element(errors.begin(), errors.end());
    const auto place = static_cast<std::size_t>(worst - errors.begin());
    const auto pixel = place / 3;
    const auto channel = static_cast<int>(place % 3);
    return {.epsilon = static_cast<float>(epsilon),
            .mean_image = mean_image,
            .mean_reference = mean_reference,
            .relmse = relmse,
            .relative_rms = std::sqrt(relmse),
            .rmse = std::sqrt(mse),
            .smape = smape,
            .bias = mean_image - mean_reference,
            .relative_bias = mean_image / mean_reference - 1,
            .relative_error_p99 = quantile(errors, 0.99),
            .relative_error_max = *worst,
            .worst = {pixel, channel, image[pixel][channel], reference[pixel][channel]},
            .worst_share = share_of_worst(errors)};
}

}  // namespace common
