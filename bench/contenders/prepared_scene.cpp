#include "bench/contenders/prepared_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/input_error.h"
#include "photonmap/gather_settings.h"

namespace bench {
namespace {

std::vector<std::string> describe_trouble(const common::Scene& scene, const std::vector<shlm::LightmapUv>& uv,
                                          shlm::TexelPlacement placement) {
    switch (placement) {
        case shlm::TexelPlacement::uv:
            return shlm::describe_lightmap_trouble(scene, uv);
        case shlm::TexelPlacement::automatic:
            return shlm::describe_useless_uv(scene, uv);
        case shlm::TexelPlacement::face:
            break;
    }
    return {};
}

}  // namespace

PreparedScene::PreparedScene(const LoadedScene& scene, const ContenderSettings& settings)
    : scene_(&scene.scene),
      rays_(&scene.rays),
      settings_(settings),
      uv_([&] { return shlm::find_lightmap_uv(scene.scene); }),
      trouble_(describe_trouble(scene.scene, uv_.value, settings.texels.placement)) {
    if (settings_.max_radius == 0)
        settings_.max_radius = photonmap::default_max_radius(scene.scene.diagonal());
}

std::string describe(const ContenderSettings& settings) {
    const std::string direct =
        settings.direct.is_traced ? fmt::format(" direct=traced,{}", settings.direct.samples) : "";
    const bool is_sobol = settings.emission == common::EmissionSequence::sobol;
    return fmt::format("texels={} max-radius={}{}{}", describe(settings.texels),
                       settings.max_radius == 0 ? "auto" : fmt::format("{}", settings.max_radius), direct,
                       is_sobol ? " emission=sobol" : "");
}

const common::reference::Lights& PreparedScene::lights() {
    if (!lights_) lights_.emplace(*scene_);
    return *lights_;
}

const shlm::PreparedTexels& PreparedScene::texels(const TexelChoice& choice) {
    return timed_texels(choice).made.value;
}

const common::CoveringSurfaces& PreparedScene::covers() {
    const common::SurfacePieces& of_scene = pieces().value;
    if (!covers_) covers_.emplace([&] { return common::CoveringSurfaces(*rays_, of_scene); });
    return covers_->value;
}

Preparation PreparedScene::preparation_of_texels(const TexelChoice& choice) {
    const TimedTexels& texels = timed_texels(choice);
    return {uv_.seconds + pieces().seconds + texels.made.seconds, texels.made.value.bytes()};
}

Preparation PreparedScene::preparation_of_texel_tree(const TexelChoice& choice) {
    TimedTexels& texels = timed_texels(choice);
    if (texels.tree_seconds == 0) {
        const common::Stopwatch watch;
        (void)texels.made.value.tree();
        texels.tree_seconds = watch.seconds();
    }
    Preparation preparation = preparation_of_texels(choice);
    preparation.seconds += texels.tree_seconds;
    return preparation;
}

Preparation PreparedScene::preparation_of_covers() {
    const std::size_t bytes = covers().bytes();
    return {pieces().seconds + covers_->seconds, bytes};
}

auto PreparedScene::pieces() -> const Timed<common::SurfacePieces>& {
    if (!pieces_) pieces_.emplace([this] { return common::SurfacePieces(*scene_); });
    return *pieces_;
}

auto PreparedScene::timed_texels(const TexelChoice& choice) -> TimedTexels& {
    const bool by_uv = choice.placement == shlm::TexelPlacement::uv;
    const bool possible = std::any_of(uv_.value.begin(), uv_.value.end(), [&](const shlm::LightmapUv& uv) {
        return shlm::placed_by_uv(uv, choice.placement) || shlm::placed_by_face(uv, choice.placement);
    });
    if (!possible) {
        const std::vector<std::string> trouble = shlm::describe_lightmap_trouble(*scene_, uv_.value);
        throw common::InputError(
            fmt::format("{}: {}", scene_->source,
                        trouble.empty() || !by_uv ? "no diffuse surface for a light map" : trouble.front()));
    }
    const common::SurfacePieces& of_scene = pieces().value;
    const auto make = [&] {
        return shlm::PreparedTexels(*scene_, uv_.value, choice.count, choice.placement, of_scene);
    };
    return texels_.try_emplace({choice.count, choice.placement}, make).first->second;
}

}  // namespace bench
