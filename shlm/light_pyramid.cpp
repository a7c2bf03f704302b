#include "shlm/light_pyramid.h"

namespace shlm {
namespace {

/// As TexelBlocks has it: parts of a block may face away from its mean by 25 degrees.
constexpr double same_block_cosine = 0.9;

LightBlock block_of(const TexelSum<AdaptiveModel>& sum, const TexelGeometry& geometry, float watts_per_flux) {
    LightBlock block;
    if (geometry.area == 0) return block;
    block.area = geometry.area;
    block.hits = static_cast<double>(sum.hits);
    block.normal = Imath::V3d(geometry.normal) * block.area;
    block.center = Imath::V3d(geometry.center) * block.area;
    for (std::size_t k = 0; k < block.watts.size(); ++k)
        block.watts[k] = static_cast<float>(sum.value[k] * static_cast<double>(watts_per_flux));
    return block;
}

void add(LightBlock& block, const LightBlock& part) {
    block.area += part.area;
    block.hits += part.hits;
    block.normal += part.normal;
    block.center += part.center;
    for (std::size_t k = 0; k < block.watts.size(); ++k) block.watts[k] += part.watts[k];
}

bool belongs_to(const LightBlock& part, const LightBlock& block, double width) {
    if (part.area == 0) return true;
    const double cosine = part.normal.dot(block.normal) / (part.normal.length() * block.normal.length());
    const double apart = (part.center / part.area - block.center / block.area).length();
    return part.one_surface && cosine >= same_block_cosine && apart <= width;
}

}  // namespace

BlockLight LightBlock::light() const {
    BlockLight light;
    light.by_normal.fill(common::Rgb(0, 0, 0));
    if (area == 0) return light;
    const auto per_area = static_cast<float>(1 / area);
    for (std::size_t i = 0; i < light.by_normal.size(); ++i)
        light.by_normal[i] = rgb_at(watts, 3 * i) * (per_area * AdaptiveModel::finishing_factor(i));
    light.surface = rgb_at(watts, 3 * AdaptiveModel::summed_harmonics) * per_area;
    return light;
}

LightPyramid::LightPyramid(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels,
                           float watts_per_flux, const RegionFace& face) {
    const TexelRegion& region = texels.layout.regions()[face.region];
    const std::uint32_t first = region.first_texel + (face.back ? region.texels_per_face() : 0);
    level_.push_back({region.width, region.height, 0, {}});
    level_[0].block.reserve(region.texels_per_face());
    double largest_area = 0;
    for (std::uint32_t i = 0; i < region.texels_per_face(); ++i) {
        level_[0].block.push_back(block_of(sums[first + i], texels.geometry[first + i], watts_per_flux));
        largest_area = std::max(largest_area, level_[0].block.back().area);
    }
    while (level_.back().block.size() > 1) {
        const std::uint32_t width = (level_.back().width + 1) / 2, height = (level_.back().height + 1) / 2;
        level_.push_back(
            {width, height, block_count(), std::vector<LightBlock>(std::size_t{width} * height)});
        join(level_.size() - 1, std::sqrt(largest_area));
    }
}

void LightPyramid::join(std::size_t level, double texel_width) {
    Level& here = level_[level];
    const double width = std::ldexp(texel_width, static_cast<int>(level));
    for (std::uint32_t y = 0; y < here.height; ++y)
        for (std::uint32_t x = 0; x < here.width; ++x) {
            LightBlock& joined = here.block[std::size_t{y} * here.width + x];
            for_children(level, x, y, [&](auto cx, auto cy) { add(joined, block(level - 1, cx, cy)); });
            for_children(level, x, y, [&](auto cx, auto cy) {
                joined.one_surface =
                    joined.one_surface && belongs_to(block(level - 1, cx, cy), joined, width);
            });
        }
}

}  // namespace shlm
