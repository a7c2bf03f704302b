#include "common/difference/flip_perception.h"

#include <oneapi/tbb/parallel_for.h>

namespace common {
namespace {

struct OpponentPlanes {
    Plane y, cx, cz;
};

OpponentPlanes opponent_planes(std::span<const Rgb> displayed, int width, int height) {
    OpponentPlanes planes = {Plane(width, height), Plane(width, height), Plane(width, height)};
    tbb::parallel_for(std::size_t{0}, displayed.size(), [&](std::size_t p) {
        const OpponentColor color = opponent_color(displayed[p]);
        planes.y.values[p] = color.y;
        planes.cx.values[p] = color.cx;
        planes.cz.values[p] = color.cz;
    });
    return planes;
}

Plane filtered(const Plane& plane, const WeightedKernel& filter) {
    return filtered(plane, filter.kernel, filter.kernel);
}

std::vector<HuntLab> blurred_colors(const OpponentPlanes& planes, const ContrastFilters& filters) {
    const Plane y = filtered(planes.y, filters.y), cx = filtered(planes.cx, filters.cx);
    const Plane narrow = filtered(planes.cz, filters.cz_narrow), wide = filtered(planes.cz, filters.cz_wide);
    std::vector<HuntLab> colors(y.values.size());
    tbb::parallel_for(std::size_t{0}, colors.size(), [&](std::size_t p) {
        const float cz =
            filters.cz_narrow.weight * narrow.values[p] + filters.cz_wide.weight * wide.values[p];
        colors[p] = hunt_lab(displayed_color({y.values[p], cx.values[p], cz}));
    });
    return colors;
}

/// Detects edges and points in the image before blurring, with black at 0 and white at 1.
std::vector<Features> features_in(const Plane& y, const FeatureFilters& filters) {
    constexpr float white_minus_black = 116;
    const Plane edge_x = filtered(y, filters.edge, filters.gaussian);
    const Plane edge_y = filtered(y, filters.gaussian, filters.edge);
    const Plane point_x = filtered(y, filters.point, filters.gaussian);
    const Plane point_y = filtered(y, filters.gaussian, filters.point);
    std::vector<Features> features(y.values.size());
    tbb::parallel_for(std::size_t{0}, features.size(), [&](std::size_t p) {
        features[p] = {std::hypot(edge_x.values[p], edge_y.values[p]) / white_minus_black,
                       std::hypot(point_x.values[p], point_y.values[p]) / white_minus_black};
    });
    return features;
}

}  // namespace

PerceivedImage perceived(std::span<const Rgb> displayed, int width, int height, const FlipFilters& filters) {
    const OpponentPlanes planes = opponent_planes(displayed, width, height);
    return {blurred_colors(planes, filters.contrast), features_in(planes.y, filters.feature)};
}

}  // namespace common
