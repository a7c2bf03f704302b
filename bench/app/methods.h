// From a method's name to its sink: the one place where all of them are known.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "bench/app/method.h"
#include "bench/app/scene_options.h"
#include "bench/app/texel_options.h"
#include "photonmap/photon_sinks.h"
#include "shlm/sink.h"

namespace bench {

/// What a method's name leaves open.
struct MethodSettings {
    TexelChoice texels;
    float max_radius = 0;  ///< of a photon map's k nearest, world units; 0: the default
};

/// "texels=262144 max-radius=auto", "texels=face,262144 max-radius=0.5"
[[nodiscard]] std::string describe(const MethodSettings& settings);

/// What the methods prepare once for a scene, whatever its light: the photon map what covers what, the light
/// map its texels.
class PreparedMethods {
  public:
    PreparedMethods(const LoadedScene& scene, const MethodSettings& settings);

    [[nodiscard]] const common::Scene& scene() const { return *scene_; }
    [[nodiscard]] const MethodSettings& settings() const { return settings_; }

    /// Lines about the lightmap coordinates; empty where all is well.
    [[nodiscard]] const std::vector<std::string>& lightmap_trouble() const { return trouble_; }
    [[nodiscard]] const std::vector<shlm::LightmapUv>& lightmap_uv() const { return uv_; }

    /// Made when first asked for. Throws InputError where no surface can have any.
    [[nodiscard]] const shlm::PreparedTexels& texels() { return texels(settings_.texels); }
    [[nodiscard]] const shlm::PreparedTexels& texels(const TexelChoice& choice);
    [[nodiscard]] const shlm::PreparedTexels& texels_of(const ShlmMethod& method) {
        return texels(texel_choice(method, settings_));
    }

    /// Made when first asked for.
    [[nodiscard]] const common::CoveringSurfaces& covers() {
        return covers_ ? *covers_ : covers_.emplace(*rays_);
    }

    /// Makes what this method needs of the scene, unless it is there: no part of a run.
    void prepare(const Method& method) {
        if (method.light_map())
            (void)texels_of(*method.light_map());
        else
            (void)covers();
    }

    [[nodiscard]] static TexelChoice texel_choice(const ShlmMethod& method, const MethodSettings& settings) {
        return {method.texels > 0 ? method.texels : settings.texels.count,
                method.placement.value_or(settings.texels.placement)};
    }

  private:
    const common::Scene* scene_;
    const common::RayScene* rays_;
    MethodSettings settings_;
    std::vector<shlm::LightmapUv> uv_;
    std::vector<std::string> trouble_;
    std::map<std::pair<std::size_t, shlm::TexelPlacement>, shlm::PreparedTexels> texels_;
    std::optional<common::CoveringSurfaces> covers_;
};

template <int Order, class Work>
auto with_weight(shlm::ShWeight weight, Work work) {
    switch (weight) {
        case shlm::ShWeight::flux:
            return work(shlm::TexelModel<Order, shlm::ShWeight::flux>{});
        case shlm::ShWeight::normalised:
            return work(shlm::TexelModel<Order, shlm::ShWeight::normalised>{});
        case shlm::ShWeight::radiance:
            break;
    }
    return work(shlm::TexelModel<Order, shlm::ShWeight::radiance>{});
}

/// Calls `work` with an object of the method's texel model.
template <class Work>
auto with_model(const ShlmMethod& method, Work work) {
    switch (summed_order(method.basis)) {
        case 0:
            return with_weight<0>(method.weight, work);
        case 1:
            return with_weight<1>(method.weight, work);
        case 4:
            return with_weight<4>(method.weight, work);
        default:
            return with_weight<2>(method.weight, work);
    }
}

[[nodiscard]] inline photonmap::GatherSettings gather_of(const PhotonMapMethod& method, float max_radius) {
    return {method.selection, method.kernel, max_radius};
}

/// Calls `work` with a fresh, empty sink of the method for photons of `source`.
template <class Work>
auto with_sink(const Method& method, PreparedMethods& prepared, const common::PhotonSource& source,
               Work work) {
    if (const ShlmMethod* light_map = method.light_map())
        return with_model(*light_map, [&](auto model) {
            return work(shlm::Sink<decltype(model)>(prepared.texels_of(*light_map), light_map->gather,
                                                    shlm::Quantum(source.power()), light_map->least_hits));
        });
    const PhotonMapMethod& photon_map = *method.photon_map();
    const photonmap::GatherSettings gather = gather_of(photon_map, prepared.settings().max_radius);
    const common::CoveringSurfaces* covers = &prepared.covers();
    switch (photon_map.engine) {
        case PhotonMapEngine::nanoflann:
            return work(photonmap::NanoflannPhotonSink(prepared.scene(), gather, covers));
        case PhotonMapEngine::grid:
            return work(photonmap::GridPhotonSink(prepared.scene(), gather, covers));
        case PhotonMapEngine::compact:
            return work(photonmap::CompactPhotonSink(prepared.scene(), gather, covers));
        case PhotonMapEngine::flann_incremental:
            return work(photonmap::FlannIncrementalPhotonSink(prepared.scene(), gather, covers));
        case PhotonMapEngine::flann:
            break;
    }
    return work(photonmap::FlannPhotonSink(prepared.scene(), gather, covers));
}

}  // namespace bench
