// The flux that stores keep of traced hits.
#pragma once

#include "bench/experiments/stability/known_light.h"
#include "bench/setup/traced_hits.h"

namespace bench::stability {

/// Returns the flux of all photons that a photon map stores, in the unit of HitBatch::flux.
[[nodiscard]] double light_in_photons(const common::HitBatch& hits);

/// Returns irradiance times area, summed over all texels of a light map, in the unit of HitBatch::flux.
template <shlm::ShWeight Weight = shlm::ShWeight::normalised>
[[nodiscard]] double light_in_texels(const shlm::PreparedTexels& texels, const common::HitBatch& hits) {
    using Model = shlm::TexelModel<0, Weight>;
    const auto map = light_map_of<Model>(texels, hits, shlm::OwnTexel{});
    double sum = 0;
    for (const auto& texel : map.texels())
        sum += double{texel.face.area} * common::mean_component(texel.irradiance(texel.face.normal));
    return sum;
}

/// Makes a closed box of side 2 around the origin, with walls of this albedo and a point light of 4 pi W
/// inside.
[[nodiscard]] common::Scene lit_box(float albedo);

}  // namespace bench::stability
