#include "bench/setup/query_points.h"

#include <random>

#include "common/core/input_error.h"
#include "common/view/visible_surfaces.h"

namespace bench {

QueryPoints visible_query_points(const LoadedScene& scene, std::uint64_t seed) {
    QueryPoints points;
    for (const common::VisibleSurface& pixel : common::visible_surfaces(scene.rays, scene.camera, 96, 54))
        if (pixel.present) points.image_order.push_back(pixel.point);
    if (points.image_order.empty())
        throw common::InputError(scene.scene.source +
                                 ": the camera sees no diffuse surface; give another with --camera");

    points.shuffled = points.image_order;
    std::mt19937_64 random(seed);
    // Written out because std::shuffle differs between standard libraries.
    for (std::size_t i = points.shuffled.size() - 1; i > 0; --i)
        std::swap(points.shuffled[i], points.shuffled[random() % (i + 1)]);
    return points;
}

}  // namespace bench
