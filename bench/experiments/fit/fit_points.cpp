#include "bench/experiments/fit/fit_points.h"

#include <random>

#include "common/core/input_error.h"

namespace bench::fit {
namespace {

constexpr std::uint32_t width = 96, height = 54, tile_side = 6;
constexpr std::uint32_t tiles_across = width / tile_side, tiles_down = height / tile_side;
constexpr std::uint32_t places = 4;  // across each pixel, and down

/// Returns what is seen at a random position in each pixel. A regular grid would hit the whole of a narrow
/// groove that runs along its rows, or miss it.
std::vector<common::VisibleSurface> seen_by_pixel(const LoadedScene& scene) {
    const auto seen =
        common::visible_surfaces(scene.rays, scene.camera, int{places * width}, int{places * height});
    std::mt19937 random;  // the same points in every fit
    std::vector<common::VisibleSurface> drawn;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const auto place = static_cast<std::uint32_t>(random() % (places * places));
            const std::uint32_t column = x * places + place % places, row = y * places + place / places;
            drawn.push_back(seen[std::size_t{row} * places * width + column]);
        }
    return drawn;
}

}  // namespace

FitPoints find_fit_points(const LoadedScene& scene) {
    FitPoints points;
    points.tiling = {tiles_across, tiles_down};
    const auto seen = seen_by_pixel(scene);
    for (std::uint32_t pixel = 0; pixel < seen.size(); ++pixel) {
        if (!seen[pixel].present) continue;
        points.point.push_back(seen[pixel].point);
        points.seen.push_back(seen[pixel]);
        points.tile.push_back(pixel / width / tile_side * tiles_across + pixel % width / tile_side);
    }
    if (points.point.empty())
        throw common::InputError(scene.scene.source +
                                 ": the camera sees no diffuse surface; give another with --camera");
    return points;
}

}  // namespace bench::fit
