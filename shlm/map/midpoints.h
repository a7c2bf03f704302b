// Values at the middles of texels, from their means.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "shlm/layout/prepared_texels.h"

namespace shlm {

/// Returns what the light is at each texel's middle, of numbers that are its mean over each texel, in the
/// layout's order. The mean over a width h of a smooth function is more than its value in the middle by h^2 /
/// 24 times the second derivative, along either axis. So a 24th of the second differences is taken off
/// (deconvolution of a box, to second order). Where a neighbour is beyond the chart, uncovered, or faces
/// another way, the difference along that axis counts as 0. The results may be negative beside edges of
/// light.
template <std::size_t Count>
[[nodiscard]] std::vector<std::array<common::Rgb, Count>> midpoints(
    const PreparedTexels& texels, const std::vector<std::array<common::Rgb, Count>>& means) {
    constexpr float share = 1.0f / 24;
    std::vector<std::array<common::Rgb, Count>> values = means;
    const auto correct = [&](std::uint32_t texel, std::uint32_t before, std::uint32_t after) {
        for (const std::uint32_t beside : {before, after}) {
            const TexelGeometry &own = texels.geometry[texel], &other = texels.geometry[beside];
            if (other.area == 0 || other.normal.dot(own.normal) <= common::same_surface_cosine) return;
        }
        for (std::size_t i = 0; i < Count; ++i)
            values[texel][i] -= (means[before][i] - means[texel][i] * 2.0f + means[after][i]) * share;
    };
    const auto correct_face = [&](const TexelRegion& region, std::uint32_t first) {
        for (std::uint32_t y = 0; y < region.height; ++y)
            for (std::uint32_t x = 0; x < region.width; ++x) {
                const std::uint32_t texel = first + y * region.width + x;
                if (texels.geometry[texel].area == 0) continue;
                if (x > 0 && x + 1 < region.width) correct(texel, texel - 1, texel + 1);
                if (y > 0 && y + 1 < region.height)
                    correct(texel, texel - region.width, texel + region.width);
            }
    };
    const std::span<const TexelRegion> regions = texels.layout.regions();
    tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t r) {
        correct_face(regions[r], regions[r].first_texel_of(false));
        if (regions[r].both_faces) correct_face(regions[r], regions[r].first_texel_of(true));
    });
    return values;
}

}  // namespace shlm
