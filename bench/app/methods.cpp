#include "bench/app/methods.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/input_error.h"

namespace bench {

PreparedMethods::PreparedMethods(const LoadedScene& scene, const MethodSettings& settings)
    : scene_(&scene.scene),
      settings_(settings),
      uv_(shlm::find_lightmap_uv(scene.scene)),
      trouble_(shlm::describe_lightmap_trouble(scene.scene, uv_)) {
    if (settings_.max_radius == 0)
        settings_.max_radius = photonmap::default_max_radius(scene.scene.diagonal());
}

std::string describe(const MethodSettings& settings) {
    return fmt::format("texels={} max-radius={}", settings.texels,
                       settings.max_radius == 0 ? "auto" : fmt::format("{}", settings.max_radius));
}

const shlm::PreparedTexels& PreparedMethods::texels(std::size_t count) {
    const bool usable =
        std::any_of(uv_.begin(), uv_.end(), [](const shlm::LightmapUv& uv) { return uv.texcoord_set >= 0; });
    if (!usable)
        throw common::InputError(
            fmt::format("{}: {}", scene_->source,
                        trouble_.empty() ? "no diffuse surface for a light map" : trouble_.front()));
    return texels_.try_emplace(count, *scene_, uv_, count).first->second;
}

}  // namespace bench
