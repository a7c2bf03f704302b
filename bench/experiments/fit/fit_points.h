// The points at which a fit asks its candidates.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/experiments/fit/tiling.h"
#include "bench/setup/scene_options.h"
#include "common/view/visible_surfaces.h"

namespace bench::fit {

struct FitPoints {
    std::vector<common::SurfacePoint>
        point;  ///< what the camera sees in 96 x 54 pixels, row by row, at a place drawn in each
    std::vector<common::VisibleSurface> seen;  ///< the same points, for paths to start at
    std::vector<std::uint32_t> tile;           ///< of each point: the part of the image that it is in
    Tiling tiling;
};

/// Tiles are larger than the blur of any candidate worth having, so that noise in one says nothing of the
/// noise in another, and many, so that their sums have a spread that can be measured. Throws InputError where
/// the camera sees no diffuse surface.
[[nodiscard]] FitPoints find_fit_points(const LoadedScene& scene);

}  // namespace bench::fit
