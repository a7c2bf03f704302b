#include "common/difference/flip.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "common/core/input_error.h"
#include "common/difference/flip_exposures.h"
#include "common/difference/flip_perception.h"

namespace common {
namespace {

// Andersson et al. 2020, sections 4.1 and 4.2.
constexpr float color_exponent = 0.7f;
constexpr float feature_exponent = 0.5f;

FlipFilters flip_filters() {
    return {contrast_filters(flip_pixels_per_degree), feature_filters(flip_pixels_per_degree)};
}

/// Returns the largest difference of colours that a display can show: green to blue.
float largest_color_difference() {
    return std::pow(hyab_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), color_exponent);
}

/// Maps a colour difference to 0 to 1. The smaller 0.4 of the differences take 0.95 of the range, as all
/// beyond look large.
float color_difference(const HuntLab& p, const HuntLab& q, float largest) {
    constexpr float knee = 0.4f, at_knee = 0.95f;
    const float share = std::pow(hyab_distance(p, q), color_exponent) / largest;
    return share < knee ? share * (at_knee / knee) : at_knee + (share - knee) / (1 - knee) * (1 - at_knee);
}

/// Returns, from 0 to 1, how much an edge or a point stands out in only one of the two.
float feature_difference(const Features& p, const Features& q) {
    const float larger = std::max(std::abs(p.edge - q.edge), std::abs(p.point - q.point));
    return std::pow(larger / std::numbers::sqrt2_v<float>, feature_exponent);
}

void check_images(std::span<const Rgb> image, std::span<const Rgb> reference, int width, int height) {
    const auto pixels = static_cast<std::size_t>(width) * height;
    if (width < 1 || height < 1 || image.size() != pixels || reference.size() != pixels)
        throw InputError(fmt::format("FLIP: {} and {} pixels are no two images of {} x {}", image.size(),
                                     reference.size(), width, height));
    const auto finite = [](const Rgb& color) { return is_finite(color); };
    if (!std::all_of(image.begin(), image.end(), finite) ||
        !std::all_of(reference.begin(), reference.end(), finite))
        throw InputError("FLIP: an image has values that are not finite");
}

}  // namespace

std::vector<float> displayed_flip_map(std::span<const Rgb> image, std::span<const Rgb> reference, int width,
                                      int height) {
    check_images(image, reference, width, height);
    const FlipFilters filters = flip_filters();
    const auto seen = perceived(image, width, height, filters);
    const auto expected = perceived(reference, width, height, filters);
    const float largest = largest_color_difference();
    std::vector<float> map(image.size());
    tbb::parallel_for(std::size_t{0}, image.size(), [&](std::size_t p) {
        map[p] = std::pow(color_difference(seen.color[p], expected.color[p], largest),
                          1 - feature_difference(seen.features[p], expected.features[p]));
    });
    return map;
}

std::vector<float> flip_map(std::span<const Rgb> image, std::span<const Rgb> reference, int width,
                            int height) {
    check_images(image, reference, width, height);
    return flip_map(image, reference, width, height, exposures_for(reference));
}

std::vector<float> flip_map(std::span<const Rgb> image, std::span<const Rgb> reference, int width, int height,
                            const Exposures& exposures) {
    check_images(image, reference, width, height);
    std::vector<float> map(image.size(), 0.0f);
    for (int i = 0; i < exposures.count; ++i) {
        const double stop = exposures.at(i);
        const auto at_stop =
            displayed_flip_map(displayed(image, stop), displayed(reference, stop), width, height);
        std::transform(map.begin(), map.end(), at_stop.begin(), map.begin(),
                       [](float p, float q) { return std::max(p, q); });
    }
    return map;
}

double flip_mean(std::span<const float> map) {
    return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

}  // namespace common
