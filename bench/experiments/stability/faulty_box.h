// A box with walls that a light map cannot store.
#pragma once

#include "bench/experiments/stability/known_light.h"

namespace bench::stability {

/// A closed box with a light in its middle, so that each wall gets a sixth of all hits of any order. `faulty`
/// walls have no lightmap coordinates, and as many others show their backs.
struct FaultyBox {
    common::Scene scene;
    shlm::PreparedTexels texels, by_face;

    explicit FaultyBox(std::size_t faulty)
        : scene(scene_with(faulty)),
          texels(texels_of(scene, 600)),
          by_face(scene, shlm::find_lightmap_uv(scene), 600, shlm::TexelPlacement::face) {}

    static common::Scene scene_with(std::size_t faulty) {
        common::Scene scene;
        const auto walls = scene_builder::box_walls({-1, -1, -1}, {1, 1, 1});
        for (std::size_t i = 0; i < walls.size(); ++i) {
            scene_builder::Mesh wall = walls[i];
            if (i < faulty) wall.texcoord = {};
            if (i >= walls.size() - faulty)
                for (auto& [a, b, c] : wall.triangle) std::swap(b, c);
            add(scene, wall, scene_builder::diffuse({0.5f, 0.5f, 0.5f}));
        }
        scene.point_light.push_back({{0, 0, 0}, {1, 1, 1}});
        return scene;
    }
};

}  // namespace bench::stability
