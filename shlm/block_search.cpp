#include "shlm/block_search.h"

#include <oneapi/tbb/parallel_for.h>

namespace shlm {
namespace {

bool is_flat(const LightPyramid& pyramid) {
    const common::Vec3 mean = pyramid.largest_block().surface.unit_normal();
    for (std::uint32_t y = 0; y < pyramid.height(0); ++y)
        for (std::uint32_t x = 0; x < pyramid.width(0); ++x) {
            const BlockSurface& surface = pyramid.block(0, x, y).surface;
            if (surface.area > 0 && surface.unit_normal().dot(mean) < straight_cosine) return false;
        }
    return true;
}

/// Sets all faces' choices; returns the map's error.
double choose_all(std::span<const LightPyramid> pyramids, double byte_price, double area,
                  std::span<FaceBlocks> faces) {
    tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
        faces[f].choice = choose_blocks(pyramids[f], faces[f].costs, !faces[f].flat, byte_price);
    });
    double error_sq = 0;
    for (const FaceBlocks& face : faces) error_sq += face.choice.error_sq;
    return area > 0 ? std::sqrt(error_sq / area) : 0;
}

}  // namespace

MapBlocks search_blocks(std::span<const LightPyramid> pyramids, std::span<const NormalsInUse> normals,
                        double wanted_error) {
    MapBlocks blocks;
    blocks.face.resize(pyramids.size());
    const LightStatistics statistics = light_statistics(pyramids);
    tbb::parallel_for(std::size_t{0}, pyramids.size(), [&](std::size_t f) {
        blocks.face[f].costs = block_costs(pyramids[f], normals[pyramids[f].face().region], statistics);
        blocks.face[f].flat = is_flat(pyramids[f]);
    });
    double area = 0;
    for (const LightPyramid& pyramid : pyramids) area += pyramid.largest_block().surface.area;
    const auto error_at = [&](double byte_price) {
        return choose_all(pyramids, byte_price, area, blocks.face);
    };

    // The highest price at which the error is small enough. The error rises with it, in steps. Where it
    // cannot be small enough, a twentieth more than the least, for half the bytes or less.
    const double allowed = std::max(wanted_error, 1.05 * error_at(0));
    double low = -60, high = 60;  // binary logarithm of the price, in units of the scene's area
    for (int i = 0; i < 24; ++i) {
        const double middle = (low + high) / 2;
        (error_at(area * std::exp2(middle)) <= allowed ? low : high) = middle;
    }
    blocks.error = error_at(area * std::exp2(low));
    return blocks;
}

}  // namespace shlm
