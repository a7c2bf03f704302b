#include "common/difference/flip_perception.h"

#include <oneapi/tbb/parallel_for.h>

namespace common {
namespace {

struct OpponentPlanes {
    Plane y, cx, cz;
};

OpponentPlanes opponent_planes(std::span<const Rgb> displayed, int width, int height) {
    OpponentPlanes planes = {Plane(width, height), Plane(width, height), Plane(width, height)};
    tbb::parallel_for(0, height, [&](int row) {
        for (std::size_t p = static_cast<std::size_t>(row) * width, end = p + width; p < end; ++p) {
            const OpponentColor color = opponent_color(displayed[p]);
            planes.y.values[p] = color.y;
            planes.cx.values[p] = color.cx;
            planes.cz.values[p] = color.cz;
        }
    });
    return planes;
}

Plane filtered(const Plane& plane, const WeightedKernel& filter) {
    return filtered(plane, filter.kernel, filter.kernel);
}

void perceive_colors(const OpponentPlanes& planes, const ContrastFilters& filters,
                     std::vector<PerceivedPixel>& pixels) {
    const Plane y = filtered(planes.y, filters.y), cx = filtered(planes.cx, filters.cx);
    const Plane narrow = filtered(planes.cz, filters.cz_narrow), wide = filtered(planes.cz, filters.cz_wide);
    tbb::parallel_for(0, y.height, [&](int row) {
        for (std::size_t p = static_cast<std::size_t>(row) * y.width, end = p + y.width; p < end; ++p) {
            const float cz =
                filters.cz_narrow.weight * narrow.values[p] + filters.cz_wide.weight * wide.values[p];
            pixels[p].color = hunt_lab(displayed_color({y.values[p], cx.values[p], cz}));
        }
    });
}

/// Edges and points are looked for in what is not blurred, black 0 and white 1.
void perceive_features(const Plane& y, const FeatureFilters& filters, std::vector<PerceivedPixel>& pixels) {
    constexpr float white_minus_black = 116;
    const Plane edge_x = filtered(y, filters.edge, filters.gaussian);
    const Plane edge_y = filtered(y, filters.gaussian, filters.edge);
    const Plane point_x = filtered(y, filters.point, filters.gaussian);
    const Plane point_y = filtered(y, filters.gaussian, filters.point);
    tbb::parallel_for(0, y.height, [&](int row) {
        for (std::size_t p = static_cast<std::size_t>(row) * y.width, end = p + y.width; p < end; ++p) {
            pixels[p].edge = std::hypot(edge_x.values[p], edge_y.values[p]) / white_minus_black;
            pixels[p].point = std::hypot(point_x.values[p], point_y.values[p]) / white_minus_black;
        }
    });
}

}  // namespace

std::vector<PerceivedPixel> perceived(std::span<const Rgb> displayed, int width, int height,
                                      const FlipFilters& filters) {
    const OpponentPlanes planes = opponent_planes(displayed, width, height);
    std::vector<PerceivedPixel> pixels(displayed.size());
    perceive_colors(planes, filters.contrast, pixels);
    perceive_features(planes.y, filters.feature, pixels);
    return pixels;
}

}  // namespace common
