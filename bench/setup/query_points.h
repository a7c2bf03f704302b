// The points at which all methods are evaluated.
#pragma once

#include <vector>

#include "bench/setup/scene_options.h"

namespace bench {

/// Surface points that the camera sees, in two orders. In image order, neighbours in the image are neighbours
/// in memory, which makes the same gathers several times as fast as in shuffled order.
struct QueryPoints {
    std::vector<common::SurfacePoint> image_order;
    std::vector<common::SurfacePoint> shuffled;
};

/// Returns the points behind a grid of 96 x 54 pixels. Throws InputError where the camera sees no diffuse
/// surface.
[[nodiscard]] QueryPoints visible_query_points(const LoadedScene& scene, std::uint64_t seed);

}  // namespace bench
