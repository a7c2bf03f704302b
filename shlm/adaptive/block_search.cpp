#include "shlm/adaptive/block_search.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
BlockSearch::BlockSearch(const TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels,
                         float watts_per_flux)
    : pyramid_(light_pyramids(sums, texels, watts_per_flux)), costs_(pyramid_.size()) {
    const LightStatistics statistics = light_statistics(pyramid_);
    tbb::parallel_for(std::size_t{0}, pyramid_.size(), [&](std::size_t f) {
        costs_[f] = block_costs(pyramid_[f], texels.normals[pyramid_[f].face().region], statistics);
    });
    for (const LightPyramid& pyramid : pyramid_) area_ += pyramid.largest_block().surface.area;
}

MapBlocks BlockSearch::choose_all(double byte_price) const {
    MapBlocks blocks;
    blocks.face.resize(pyramid_.size());
    tbb::parallel_for(std::size_t{0}, pyramid_.size(), [&](std::size_t f) {
        blocks.face[f] = choose_blocks(pyramid_[f], costs_[f], byte_price);
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
