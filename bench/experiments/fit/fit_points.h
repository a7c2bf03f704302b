// The points at which a fit evaluates its candidates.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/experiments/fit/tiling.h"
#include "bench/setup/scene_options.h"
#include "common/view/visible_surfaces.h"

namespace bench::fit {

struct FitPoints {
    std::vector<common::SurfacePoint>
        point;  ///< what the camera sees in 96 x 54 pixels, row by row, at a random position in each
    std::vector<common::VisibleSurface> seen;  ///< the same points, where paths start
    std::vector<std::uint32_t> tile;           ///< of each point: the tile of the image that contains it
    Tiling tiling;
};

/// Finds the points and tiles. Tiles are larger than the blur of any useful candidate, so that their noise is
/// independent. They are also many, so that the spread of their sums can be measured. Throws InputError where
/// the camera sees no diffuse surface.
[[nodiscard]] FitPoints find_fit_points(const LoadedScene& scene);

}  // namespace bench::fit
