#include "common/difference/error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/core/input_error.h"

namespace common {
namespace {

/// The colour map magma at 17 equally spaced values (van der Walt and Smith, matplotlib 1.5, 2015; public
/// domain, CC0). Linear interpolation between them differs from it by at most 2 of 255.
constexpr std::array<DisplayColor, 17> magma_colors = {{{0, 0, 4},
                                                        {10, 8, 34},
                                                        {29, 17, 71},
                                                        {54, 16, 107},
                                                        {81, 18, 124},
                                                        {106, 28, 129},
                                                        {131, 38, 129},
                                                        {156, 46, 127},
                                                        {183, 55, 121},
                                                        {207, 64, 112},
                                                        {229, 80, 100},
                                                        {244, 105, 92},
                                                        {251, 135, 97},
                                                        {254, 165, 113},
                                                        {254, 194, 135},
                                                        {253, 224, 161},
                                                        {252, 253, 191}}};

}  // namespace

DisplayColor magma(float value) {
    constexpr std::size_t steps = magma_colors.size() - 1;
    const float position = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(steps);
    const std::size_t below = std::min(static_cast<std::size_t>(position), steps - 1);
    const float share = position - static_cast<float>(below);
    DisplayColor color;
    for (std::size_t c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(
            std::lround(std::lerp(static_cast<float>(magma_colors[below][c]),
                                  static_cast<float>(magma_colors[below + 1][c]), share)));
    return color;
}

void write_flip_map(const std::filesystem::path& file, int width, int height, std::span<const float> map) {
    if (map.size() != static_cast<std::size_t>(width) * height)
        throw InputError(
            fmt::format("{}: {} values are no map of {} x {}", file.string(), map.size(), width, height));
    std::vector<DisplayColor> colors(map.size());
    std::transform(map.begin(), map.end(), colors.begin(), magma);
    write_png(file, width, height, colors);
}

}  // namespace common
