// The simplest scene: a square of 1 x 1.
#pragma once

#include "bench/setup/scene_builder.h"

namespace bench::stability {

/// Returns a white floor from (0, 0) to (1, 1) at height 0, facing up.
[[nodiscard]] inline const common::Scene& unit_floor() {
    static const common::Scene made = [] {
        common::Scene scene;
        add(scene, scene_builder::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), scene_builder::diffuse({1, 1, 1}));
        return scene;
    }();
    return made;
}

/// Returns its point (s, t), seen from above.
[[nodiscard]] inline common::SurfacePoint on_unit_floor(float s, float t) {
    return scene_builder::front_of(unit_floor(), scene_builder::on_quad(0, s, t));
}

}  // namespace bench::stability
