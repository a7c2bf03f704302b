// The light that the stores have of traced hits.
#pragma once

#include "bench/experiments/stability/known_light.h"
#include "bench/setup/traced_hits.h"

namespace bench::stability {

/// Flux of all photons that a photon map takes, as HitBatch::flux.
[[nodiscard]] double light_in_photons(const common::HitBatch& hits);

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
[[nodiscard]] common::Scene lit_box(float albedo);

}  // namespace bench::stability
