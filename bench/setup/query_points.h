// Where the methods are asked for irradiance: the same points for all of them.
#pragma once

#include <vector>

#include "bench/setup/scene_options.h"

namespace bench {

/// Surface points that the camera sees, in two orders. Neighbours in the image are neighbours in memory too,
/// so that the same gathers are several times as fast in the first order as in the second.
struct QueryPoints {
    std::vector<common::SurfacePoint> image_order;
    std::vector<common::SurfacePoint> shuffled;
};

/// The points behind a grid of 96 x 54 pixels. Throws InputError where the camera sees no diffuse surface.
[[nodiscard]] QueryPoints visible_query_points(const LoadedScene& scene, std::uint64_t seed);

}  // namespace bench
