#include "bench/experiments/stability/known_light.h"

namespace bench::stability {

photonmap::FlannPhotonSink::Map photon_map_of(const common::Scene& scene, const common::HitBatch& hits,
                                              const photonmap::GatherSettings& gather) {
    return map_of(photonmap::FlannPhotonSink(scene, gather), hits);
}

photonmap::GatherSettings within(const common::Scene& scene, double radius) {
    return {.selection = photonmap::FixedRadius{radius / scene.diagonal()}};
}

photonmap::GatherSettings nearest(std::size_t k, double max_radius) {
    return {.selection = photonmap::NearestPhotons{k}, .max_radius = static_cast<float>(max_radius)};
}

shlm::PreparedTexels texels_of(const common::Scene& scene, std::size_t texels) {
    return shlm::PreparedTexels(scene, shlm::find_lightmap_uv(scene), texels);
}

shlm::Quantum quantum_of(const common::HitBatch& hits) {
    float brightest = 0;
    for (const common::Rgb& flux : hits.flux) brightest = std::max(brightest, common::max_component(flux));
    return shlm::Quantum({brightest, brightest, brightest});
}

template <class Model>
shlm::HarmonicMap<Model> light_map_of(const shlm::PreparedTexels& texels, const common::HitBatch& hits,
                                      const shlm::Gather& gather, std::uint64_t least_hits) {
    return map_of(shlm::Sink<Model>(texels, gather, quantum_of(hits), least_hits), hits);
}

using Texels = const shlm::PreparedTexels&;
using Hits = const common::HitBatch&;
using How = const shlm::Gather&;
using FlatFlux = shlm::TexelModel<0, shlm::ShWeight::flux>;
using Normalised = shlm::TexelModel<2, shlm::ShWeight::normalised>;

template shlm::HarmonicMap<FlatModel> light_map_of<FlatModel>(Texels, Hits, How, std::uint64_t);
template shlm::HarmonicMap<FlatFlux> light_map_of<FlatFlux>(Texels, Hits, How, std::uint64_t);
template shlm::HarmonicMap<HarmonicModel<0>> light_map_of<HarmonicModel<0>>(Texels, Hits, How, std::uint64_t);
template shlm::HarmonicMap<HarmonicModel<1>> light_map_of<HarmonicModel<1>>(Texels, Hits, How, std::uint64_t);
template shlm::HarmonicMap<HarmonicModel<2>> light_map_of<HarmonicModel<2>>(Texels, Hits, How, std::uint64_t);
template shlm::HarmonicMap<HarmonicModel<4>> light_map_of<HarmonicModel<4>>(Texels, Hits, How, std::uint64_t);
template shlm::HarmonicMap<Normalised> light_map_of<Normalised>(Texels, Hits, How, std::uint64_t);

}  // namespace bench::stability
