#include "shlm/adaptive/light_pyramid.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
namespace {

LightBlock block_of(const TexelSum<AdaptiveModel>& sum, const TexelGeometry& geometry, float watts_per_flux) {
    LightBlock block;
    if (geometry.area == 0) return block;
    block.surface = BlockSurface::of_texel(geometry);
    block.hits = static_cast<double>(sum.hits);
    for (std::size_t k = 0; k < block.watts.size(); ++k)
        block.watts[k] = static_cast<float>(sum.value[k] * static_cast<double>(watts_per_flux));
    return block;
}

}  // namespace

BlockLight LightBlock::light() const {
    BlockLight light;
    light.by_normal.fill(common::Rgb(0, 0, 0));
    if (surface.area == 0) return light;
    const auto per_area = static_cast<float>(1 / surface.area);
    for (std::size_t i = 0; i < light.by_normal.size(); ++i)
        light.by_normal[i] = rgb_at(watts, 3 * i) * (per_area * AdaptiveModel::finishing_factor(i));
    light.surface = rgb_at(watts, 3 * AdaptiveModel::summed_harmonics) * per_area;
    return light;
}

LightPyramid::LightPyramid(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels,
                           float watts_per_flux, const RegionFace& face)
    : face_(face) {
    const TexelRegion& region = texels.layout.regions()[face.region];
    const std::uint32_t first = region.first_texel_of(face.back);
    level_.push_back({region.width, region.height, 0, {}});
    level_[0].block.reserve(region.texels_per_face());
    for (std::uint32_t i = 0; i < region.texels_per_face(); ++i)
        level_[0].block.push_back(block_of(sums[first + i], texels.geometry[first + i], watts_per_flux));
    const double width_of_texel =
        texel_width(std::span(texels.geometry).subspan(first, region.texels_per_face()));
    while (level_.back().block.size() > 1) {
        const std::uint32_t width = (level_.back().width + 1) / 2, height = (level_.back().height + 1) / 2;
        level_.push_back(
            {width, height, block_count(), std::vector<LightBlock>(std::size_t{width} * height)});
        join(level_.size() - 1, width_of_texel);
    }
    is_flat_ = has_one_normal();
}

bool LightPyramid::has_one_normal() const {
    const common::Vec3 mean = largest_block().surface.unit_normal();
    return std::all_of(level_[0].block.begin(), level_[0].block.end(), [&](const LightBlock& texel) {
        return texel.surface.area == 0 || texel.surface.unit_normal().dot(mean) >= straight_cosine;
    });
}

void LightPyramid::join(std::size_t level, double width_of_texel) {
    Level& here = level_[level];
    const double width = std::ldexp(width_of_texel, static_cast<int>(level));
    for (std::uint32_t y = 0; y < here.height; ++y)
        for (std::uint32_t x = 0; x < here.width; ++x) {
            LightBlock& joint = here.block[std::size_t{y} * here.width + x];
            std::array<BlockSurface, 4> surfaces;
            std::size_t parts = 0;
            for_children(level, x, y, [&](auto cx, auto cy) {
                const LightBlock& part = block(level - 1, cx, cy);
                joint.hits += part.hits;
                for (std::size_t k = 0; k < joint.watts.size(); ++k) joint.watts[k] += part.watts[k];
                surfaces[parts++] = part.surface;
            });
            joint.surface = joined(std::span(surfaces).first(parts), width);
        }
}

std::vector<LightPyramid> light_pyramids(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels,
                                         float watts_per_flux) {
    std::vector<RegionFace> faces;
    const std::span<const TexelRegion> regions = texels.layout.regions();
    for (std::uint32_t r = 0; r < regions.size(); ++r) {
        faces.push_back({r, false});
        if (regions[r].both_faces) faces.push_back({r, true});
    }
    std::vector<LightPyramid> pyramids(faces.size());
    tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
        pyramids[f] = LightPyramid(sums, texels, watts_per_flux, faces[f]);
    });
    return pyramids;
}

}  // namespace shlm
