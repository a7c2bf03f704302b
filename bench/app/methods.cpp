#include "bench/app/methods.h"

#include <fmt/ranges.h>

namespace bench {

PreparedMethods::PreparedMethods(const LoadedScene& scene, const MethodSettings& settings)
    : scene_(&scene.scene),
      settings_(settings),
      uv_(shlm::find_lightmap_uv(scene.scene)),
      trouble_(shlm::describe_lightmap_trouble(scene.scene, uv_)) {
    if (settings_.photonmap.max_radius == 0)
        settings_.photonmap.max_radius = photonmap::default_max_radius(scene.scene.diagonal());
}

const shlm::PreparedTexels& PreparedMethods::texels() {
    if (!texels_) {
        const bool usable = std::any_of(uv_.begin(), uv_.end(),
                                        [](const shlm::LightmapUv& uv) { return uv.texcoord_set >= 0; });
        if (!usable)
            throw common::InputError(
                fmt::format("{}: {}", scene_->source,
                            trouble_.empty() ? "no diffuse surface for a light map" : trouble_.front()));
        texels_.emplace(*scene_, uv_, settings_.shlm.texels);
    }
    return *texels_;
}

std::string full_method_name(const std::string& option, const std::string& name) {
    if (name == "photonmap") return "photonmap/flann";
    if (std::find(method_names.begin(), method_names.end(), name) == method_names.end())
        throw common::InputError(
            fmt::format("{}: '{}' is not one of {}", option, name, fmt::join(method_names, ", ")));
    return name;
}

MethodSettings settings_of(std::string_view method, MethodSettings settings) {
    if (method == "shlm/flux") settings.shlm.weight = shlm::ShWeight::flux;
    return settings;
}

}  // namespace bench
