// The light that the stores have of traced hits.
#pragma once

#include "bench/stability/known_light.h"
#include "bench/stability/traced_hits.h"

namespace bench {

/// Flux of all photons that a photon map takes, as HitBatch::flux.
[[nodiscard]] inline double light_in_photons(const common::HitBatch& hits) {
    photonmap::PhotonStorage storage;
    storage.append(std::span(&hits, 1));
    double sum = 0;
    for (std::size_t i = 0; i < storage.size(); ++i) sum += common::mean_component(storage[i].flux);
    return sum;
}

/// Irradiance times area over all texels of a light map, as HitBatch::flux.
template <shlm::ShWeight Weight = shlm::ShWeight::normalised>
[[nodiscard]] double light_in_texels(const shlm::PreparedTexels& texels, const common::HitBatch& hits) {
    using Model = shlm::TexelModel<0, Weight>;
    const auto map = light_map_of<Model>(texels, hits, shlm::OwnTexel{});
    double sum = 0;
    for (const auto& texel : map.texels())
        sum += double{texel.face.area} * common::mean_component(texel.irradiance(texel.face.normal));
    return sum;
}

/// A closed box of side 2 around the origin with walls of this albedo and a point light of 4 pi W inside.
[[nodiscard]] inline common::Scene lit_box(float albedo) {
    common::Scene scene = scene_builder::closed_box(scene_builder::diffuse({albedo, albedo, albedo}));
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, {1, 1, 1}});
    return scene;
}

}  // namespace bench
