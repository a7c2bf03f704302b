#include "shlm/layout/texel_layout.h"

#include <fmt/format.h>

#include "common/core/input_error.h"

namespace shlm {
namespace {

using common::Vec2;

std::uint32_t texels_along(double length, double texel_size) {
    constexpr double most = 32768;  // keeps texel indices within a region exact in float
    return static_cast<std::uint32_t>(std::clamp(std::round(length / texel_size), 1.0, most));
}

int faces_of(const TexelChart& chart) {
    return chart.both_faces ? 2 : 1;
}

void place_triangle(const std::array<Vec2, 3>& corner, const TexelRegion& region, TriangleTexels& placed) {
    const Vec2 size(static_cast<float>(region.width), static_cast<float>(region.height));
    placed.corner = corner[0] * size;
    placed.edge_u = corner[1] * size - placed.corner;
    placed.edge_v = corner[2] * size - placed.corner;
    // A triangle whose coordinates span no area has no texels: its flux would be divided by 0.
    if (placed.edge_u.x * placed.edge_v.y == placed.edge_u.y * placed.edge_v.x) return;
    placed.first_texel = region.first_texel;
    placed.width = region.width;
    placed.height = region.height;
    placed.both_faces = region.both_faces;
}

RegionPlane plane_of(const TexelChart& chart, const TexelRegion& region) {
    return {common::Vec3(chart.plane->origin),
            common::Vec3(chart.plane->right * (region.width / chart.width)),
            common::Vec3(chart.plane->down * (region.height / chart.height))};
}

}  // namespace

double texels_at_size(std::span<const TexelChart> charts, double texel_size) {
    double count = 0;
    for (const TexelChart& chart : charts)
        count += static_cast<double>(faces_of(chart)) * texels_along(chart.width, texel_size) *
                 texels_along(chart.height, texel_size);
    return count;
}

double texel_size_for(std::span<const TexelChart> charts, std::size_t wanted_texels) {
    double area = 0;
    for (const TexelChart& chart : charts) area += faces_of(chart) * chart.width * chart.height;
    const double guess = std::sqrt(area / static_cast<double>(wanted_texels));
    double low = guess / 16, high = guess * 16;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (texels_at_size(charts, middle) > static_cast<double>(wanted_texels) ? low : high) = middle;
    }
    return high;
}

TexelLayout::TexelLayout(const common::Scene& scene, std::span<const TexelChart> charts,
                         std::size_t wanted_texels)
    : triangles_(scene.triangle.size()) {
    const double texel_size = texel_size_for(charts, wanted_texels);
    if (texels_at_size(charts, texel_size) >= no_texel)
        throw common::InputError(fmt::format("a light map holds fewer than {} texels; {} were asked for",
                                             no_texel, wanted_texels));

    for (std::size_t t = 0; t < triangles_.size(); ++t) triangles_[t].normal = scene.geometric_normal[t];
    regions_.reserve(charts.size());
    const bool have_planes =
        std::all_of(charts.begin(), charts.end(), [](const TexelChart& chart) { return chart.plane; });
    if (have_planes) planes_.reserve(charts.size());
    for (const TexelChart& chart : charts) {
        TexelRegion& region = regions_.emplace_back();
        region.first_texel = static_cast<std::uint32_t>(texel_count_);
        region.width = texels_along(chart.width, texel_size);
        region.height = texels_along(chart.height, texel_size);
        region.both_faces = chart.both_faces;
        if (have_planes) planes_.push_back(plane_of(chart, region));
        texel_count_ += std::size_t{region.texels_per_face()} * static_cast<std::size_t>(faces_of(chart));
        for (std::size_t i = 0; i < chart.triangle.size(); ++i)
            place_triangle(chart.corner[i], region, triangles_[chart.triangle[i]]);
    }
}

TexelLayout TexelLayout::coarser(std::span<const std::uint32_t> joined) const {
    TexelLayout result = *this;
    result.texel_count_ = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
        TexelRegion& region = result.regions_[r];
        region.first_texel = static_cast<std::uint32_t>(result.texel_count_);
        region.width = (region.width + joined[r] - 1) / joined[r];
        region.height = (region.height + joined[r] - 1) / joined[r];
        result.texel_count_ += std::size_t{region.texels_per_face()} * (region.both_faces ? 2 : 1);
        if (planes_.empty()) continue;
        result.planes_[r].right /= static_cast<float>(joined[r]);
        result.planes_[r].down /= static_cast<float>(joined[r]);
    }
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        TriangleTexels& triangle = result.triangles_[t];
        if (triangle.width == 0) continue;
        const std::size_t r = region_of(t);
        const TexelRegion& region = result.regions_[r];
        for (Vec2* at : {&triangle.corner, &triangle.edge_u, &triangle.edge_v})
            *at /= static_cast<float>(joined[r]);
        triangle.first_texel = region.first_texel;
        triangle.width = region.width;
        triangle.height = region.height;
    }
    return result;
}

}  // namespace shlm
