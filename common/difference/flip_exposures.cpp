#include "common/difference/flip_exposures.h"

#include <oneapi/tbb/parallel_for.h>

#include <limits>

#include "common/core/input_error.h"

namespace common {
namespace {

/// The tone curve f(x) = (a x^2 + b x) / (c x^2 + d x + e).
constexpr float light = 0.6f;
constexpr float a = 2.51f * light * light, b = 0.03f * light;
constexpr float c = 2.43f * light * light, d = 0.59f * light, e = 0.14f;

/// Returns the x with f(x) = `value`: the root above 0 of (a - c value) x^2 + (b - d value) x - e value.
double shown_as(double value) {
    const double half_linear = 0.5 * (b - d * value), squared = a - c * value;
    return (std::sqrt(half_linear * half_linear + squared * e * value) - half_linear) / squared;
}

float tone_mapped(float x) {
    constexpr float surely_white = 1e6f;  // and its square is still finite
    x = std::clamp(x, 0.0f, surely_white);
    const float numerator = (a * x + b) * x;
    return std::min(1.0f, numerator / ((c * x + d) * x + e));
}

/// Rec. 709.
double luminance(const Rgb& color) {
    return 0.2126 * std::max(color.x, 0.0f) + 0.7152 * std::max(color.y, 0.0f) +
           0.0722 * std::max(color.z, 0.0f);
}

}  // namespace

Exposures exposures_for(std::span<const Rgb> reference) {
    constexpr double least_median = 0x1p-23;
    constexpr double bright = 0.85;
    std::vector<double> luminances(reference.size());
    std::transform(reference.begin(), reference.end(), luminances.begin(), luminance);
    const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double median = std::max(*middle, least_median);
    const double most = *std::max_element(middle, luminances.end());
    if (!(most >= std::numeric_limits<float>::min()))  // for a darker one the exposure would be infinite
        throw InputError("the reference is black: no exposure shows it");
    const double start = std::log2(shown_as(bright) / most);
    const double stop = std::max(start, std::log2(shown_as(bright) / median));
    return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

std::vector<Rgb> displayed(std::span<const Rgb> image, double exposure) {
    const auto scale = static_cast<float>(std::exp2(exposure));
    std::vector<Rgb> shown(image.size());
    tbb::parallel_for(std::size_t{0}, image.size(), [&](std::size_t p) {
        const Rgb& color = image[p];
        shown[p] = {tone_mapped(color.x * scale), tone_mapped(color.y * scale), tone_mapped(color.z * scale)};
    });
    return shown;
}

}  // namespace common
