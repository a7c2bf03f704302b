#include "bench/experiments/fit/fit_points.h"

#include "common/core/input_error.h"
#include "common/view/visible_surfaces.h"

namespace bench::fit {
namespace {

constexpr std::uint32_t width = 96, height = 54, tile_side = 6;
constexpr std::uint32_t tiles_across = width / tile_side, tiles_down = height / tile_side;

}  // namespace

FitPoints find_fit_points(const LoadedScene& scene) {
    FitPoints points;
    points.tiling = {tiles_across, tiles_down};
    points.width = width;
    points.height = height;
    const auto seen = common::visible_surfaces(scene.rays, scene.camera, width, height);
    for (std::uint32_t pixel = 0; pixel < seen.size(); ++pixel) {
        if (!seen[pixel].present) continue;
        points.point.push_back(seen[pixel].point);
        points.pixel.push_back(pixel);
        points.tile.push_back(pixel / width / tile_side * tiles_across + pixel % width / tile_side);
    }
    if (points.point.empty())
        throw common::InputError(scene.scene.source +
                                 ": the camera sees no diffuse surface; give another with --camera");
    return points;
}

}  // namespace bench::fit
