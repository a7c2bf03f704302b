#include "shlm/adaptive/block_search.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
namespace {

bool has_one_normal(const LightPyramid& pyramid) {
    const common::Vec3 mean = pyramid.largest_block().surface.unit_normal();
    for (std::uint32_t y = 0; y < pyramid.height(0); ++y)
        for (std::uint32_t x = 0; x < pyramid.width(0); ++x) {
            const BlockSurface& surface = pyramid.block(0, x, y).surface;
            if (surface.area > 0 && surface.unit_normal().dot(mean) < straight_cosine) return false;
        }
    return true;
}

}  // namespace

BlockSearch::BlockSearch(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels,
                         float watts_per_flux)
    : pyramid_(light_pyramids(sums, texels, watts_per_flux)), face_(pyramid_.size()) {
    const LightStatistics statistics = light_statistics(pyramid_);
    tbb::parallel_for(std::size_t{0}, pyramid_.size(), [&](std::size_t f) {
        const LightPyramid& pyramid = pyramid_[f];
        face_[f] = {block_costs(pyramid, texels.normals[pyramid.face().region], statistics),
                    has_one_normal(pyramid)};
    });
    for (const LightPyramid& pyramid : pyramid_) area_ += pyramid.largest_block().surface.area;
}

MapBlocks BlockSearch::choose_all(double byte_price) const {
    MapBlocks blocks;
    blocks.face.resize(face_.size());
    tbb::parallel_for(std::size_t{0}, face_.size(), [&](std::size_t f) {
        blocks.face[f] = choose_blocks(pyramid_[f], face_[f].costs, !face_[f].flat, byte_price);
    });
    double error_sq = 0;
    for (const BlockChoice& face : blocks.face) error_sq += face.error_sq;
    if (area_ > 0) blocks.error = std::sqrt(error_sq / area_);
    return blocks;
}

MapBlocks BlockSearch::smallest(double wanted_error) const {
    // Finds the highest price at which the error is small enough; the error rises with the price, in steps.
    // If it cannot be small enough, a twentieth more than the least is allowed, which takes half the bytes or
    // less.
    const double allowed = std::max(wanted_error, 1.05 * choose_all(0).error);
    double low = -60, high = 60;  // binary logarithm of the price, in units of the scene's area
    for (int i = 0; i < 24; ++i) {
        const double middle = (low + high) / 2;
        (choose_all(area_ * std::exp2(middle)).error <= allowed ? low : high) = middle;
    }
    return choose_all(area_ * std::exp2(low));
}

}  // namespace shlm
