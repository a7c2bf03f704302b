#include "bench/experiments/stability/floor_light.h"

namespace bench::stability {

common::Scene square_floor(double width) {
    const auto w = static_cast<float>(width);
    common::Scene scene;
    add(scene, scene_builder::quad({-w / 2, -w / 2, 0}, {w, 0, 0}, {0, w, 0}),
        scene_builder::diffuse({1, 1, 1}));
    return scene;
}

common::SurfaceId on_floor(double width, double x, double y) {
    return scene_builder::on_quad(0, static_cast<float>(x / width + 0.5),
                                  static_cast<float>(y / width + 0.5));
}

common::SurfacePoint floor_point(const common::Scene& floor, double width, double x, double y) {
    return scene_builder::front_of(floor, on_floor(width, x, y));
}

std::vector<common::SurfacePoint> points_across(const common::Scene& scene, std::uint32_t first_triangle,
                                                double s) {
    std::vector<common::SurfacePoint> points;
    for (int i = 0; i < 64; ++i)
        points.push_back(scene_builder::front_of(
            scene, scene_builder::on_quad(first_triangle, static_cast<float>(s),
                                          0.15f + 0.7f * static_cast<float>(i) / 63)));
    return points;
}

}  // namespace bench::stability
