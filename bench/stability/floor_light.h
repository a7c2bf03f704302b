// Light on parts of a flat floor, and places across it.
#pragma once

#include "bench/stability/known_light.h"

namespace bench {

/// At z = 0 around the origin, one quad (scene_builder.h) that faces up, u along x and v along y.
[[nodiscard]] inline common::Scene square_floor(double width) {
    const auto w = static_cast<float>(width);
    common::Scene scene;
    add(scene, scene_builder::quad({-w / 2, -w / 2, 0}, {w, 0, 0}, {0, w, 0}),
        scene_builder::diffuse({1, 1, 1}));
    return scene;
}

/// Where (x, y) is on that floor.
[[nodiscard]] inline common::SurfaceId on_floor(double width, double x, double y) {
    return scene_builder::on_quad(0, static_cast<float>(x / width + 0.5),
                                  static_cast<float>(y / width + 0.5));
}

/// The same place as it is seen from above.
[[nodiscard]] inline common::SurfacePoint floor_point(const common::Scene& floor, double width, double x,
                                                      double y) {
    return scene_builder::front_of(floor, on_floor(width, x, y));
}

/// 64 points of a quad at `s` along its u, evenly spaced along v and away from its ends.
[[nodiscard]] inline std::vector<common::SurfacePoint> points_across(const common::Scene& scene,
                                                                     std::uint32_t first_triangle, double s) {
    std::vector<common::SurfacePoint> points;
    for (int i = 0; i < 64; ++i)
        points.push_back(scene_builder::front_of(
            scene, scene_builder::on_quad(first_triangle, static_cast<float>(s),
                                          0.15f + 0.7f * static_cast<float>(i) / 63)));
    return points;
}

/// The photons that arrive where `is_lit(position)`; the others were stopped on their way.
template <class IsLit>
[[nodiscard]] common::HitBatch lit_where(const common::HitBatch& hits, IsLit is_lit) {
    common::HitBatch lit;
    lit.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (is_lit(hits.position[i]))
            lit.push_back(hits.position[i], hits.direction[i], hits.flux[i], hits.surface[i]);
    return lit;
}

}  // namespace bench
