// What contenders need of a scene, made once, whatever its light.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/setup/scene_options.h"
#include "bench/setup/texel_options.h"
#include "common/tracer/covering_surfaces.h"
#include "shlm/layout/prepared_texels.h"

namespace bench {

/// What a contender's name leaves open.
struct ContenderSettings {
    TexelChoice texels;
    float max_radius = 0;  ///< of a photon map's k nearest, world units; 0: the default
};

/// "texels=262144 max-radius=auto", "texels=face,262144 max-radius=0.5"
[[nodiscard]] std::string describe(const ContenderSettings& settings);

/// Texels, and what covers what, are made when first asked for. Hands out places within itself, so it stays
/// where it is.
class PreparedScene {
  public:
    /// `scene` must outlive it.
    PreparedScene(const LoadedScene& scene, const ContenderSettings& settings);
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    [[nodiscard]] const common::Scene& scene() const { return *scene_; }

    /// With the default radius of this scene where none was asked for.
    [[nodiscard]] const ContenderSettings& settings() const { return settings_; }

    /// Lines about the lightmap coordinates; empty where all is well.
    [[nodiscard]] const std::vector<std::string>& lightmap_trouble() const { return trouble_; }
    [[nodiscard]] const std::vector<shlm::LightmapUv>& lightmap_uv() const { return uv_; }

    /// Throws InputError where no surface can have any.
    [[nodiscard]] const shlm::PreparedTexels& texels() { return texels(settings_.texels); }
    [[nodiscard]] const shlm::PreparedTexels& texels(const TexelChoice& choice);

    [[nodiscard]] const common::CoveringSurfaces& covers() {
        return covers_ ? *covers_ : covers_.emplace(*rays_);
    }

  private:
    const common::Scene* scene_;
    const common::RayScene* rays_;
    ContenderSettings settings_;
    std::vector<shlm::LightmapUv> uv_;
    std::vector<std::string> trouble_;
    std::map<std::pair<std::size_t, shlm::TexelPlacement>, shlm::PreparedTexels> texels_;
    std::optional<common::CoveringSurfaces> covers_;
};

}  // namespace bench
