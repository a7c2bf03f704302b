// The methods by name: the one place where all of them are known.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "bench/app/scene_options.h"
#include "common/core/input_error.h"
#include "photonmap/photon_sinks.h"
#include "shlm/sink.h"

namespace bench {

/// Stable names, as they appear in every table.
inline constexpr std::array<std::string_view, 4> method_names = {
    "photonmap/flann", "photonmap/flann-incremental", "shlm", "shlm/flux"};

struct MethodSettings {
    photonmap::GatherSettings photonmap;  ///< max_radius 0: the default for the scene
    shlm::Settings shlm;
};

/// What the methods prepare once for a scene, whatever its light: the photon map nothing, the light map its
/// texels.
class PreparedMethods {
  public:
    PreparedMethods(const LoadedScene& scene, const MethodSettings& settings);

    [[nodiscard]] const common::Scene& scene() const { return *scene_; }
    [[nodiscard]] const MethodSettings& settings() const { return settings_; }

    /// Lines about the lightmap coordinates; empty where all is well.
    [[nodiscard]] const std::vector<std::string>& lightmap_trouble() const { return trouble_; }
    [[nodiscard]] const std::vector<shlm::LightmapUv>& lightmap_uv() const { return uv_; }

    /// Made when first asked for. Throws InputError where no surface has usable lightmap coordinates.
    [[nodiscard]] const shlm::PreparedTexels& texels();

  private:
    const common::Scene* scene_;
    MethodSettings settings_;
    std::vector<shlm::LightmapUv> uv_;
    std::vector<std::string> trouble_;
    std::optional<shlm::PreparedTexels> texels_;
};

/// "photonmap" is short for "photonmap/flann". Throws InputError, naming the option and the known methods,
/// for any other name.
[[nodiscard]] std::string full_method_name(const std::string& option, const std::string& name);

/// The settings as the method takes them: shlm/flux brings its own weight.
[[nodiscard]] MethodSettings settings_of(std::string_view method, MethodSettings settings);

/// Calls `work` with a fresh, empty sink of the method. `method` is a full name.
template <class Work>
auto with_sink(std::string_view method, PreparedMethods& prepared, Work work) {
    const common::Scene& scene = prepared.scene();
    const MethodSettings settings = settings_of(method, prepared.settings());
    if (method == "photonmap/flann") return work(photonmap::FlannPhotonSink(scene, settings.photonmap));
    if (method == "photonmap/flann-incremental")
        return work(photonmap::FlannIncrementalPhotonSink(scene, settings.photonmap));
    return work(shlm::Sink(prepared.texels(), settings.shlm));
}

}  // namespace bench
