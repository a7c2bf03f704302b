// Data that contenders derive from a scene once, independent of its light.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/setup/scene_options.h"
#include "bench/setup/texel_options.h"
#include "common/core/stopwatch.h"
#include "common/reference/lights.h"
#include "common/tracer/covering_surfaces.h"
#include "common/tracer/photon_source.h"
#include "shlm/layout/prepared_texels.h"

namespace bench {

/// Where direct light comes from (direct_light.h).
struct DirectSetting {
    bool is_traced = false;      ///< sampled at each question, not brought by photons
    std::uint32_t samples = 64;  ///< at each question, if so
};

/// Settings that a contender's name does not determine.
struct ContenderSettings {
    TexelChoice texels;
    float max_radius = 0;  ///< of a photon map's k nearest, scene units; 0: the default
    DirectSetting direct{};
    common::EmissionSequence emission = common::EmissionSequence::random;
};

/// Formats as "texels=262144 max-radius=auto" or "texels=face,262144 max-radius=0.5 direct=traced,64
/// emission=sobol".
[[nodiscard]] std::string describe(const ContenderSettings& settings);

/// The cost of making something once for a scene, before any photon.
struct Preparation {
    double seconds = 0;     ///< wall time
    std::size_t bytes = 0;  ///< kept beside all maps of the scene
};

/// Makes texels and covering surfaces when they are first needed. It returns references to its members, so it
/// is not movable.
class PreparedScene {
  public:
    /// `scene` must outlive it.
    PreparedScene(const LoadedScene& scene, const ContenderSettings& settings);
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    [[nodiscard]] const common::Scene& scene() const { return *scene_; }

    /// Returns the settings, with the scene's default radius where none was given.
    [[nodiscard]] const ContenderSettings& settings() const { return settings_; }

    /// Returns lines about problems of the lightmap coordinates; empty if there are none.
    [[nodiscard]] const std::vector<std::string>& lightmap_trouble() const { return trouble_; }
    [[nodiscard]] const std::vector<shlm::LightmapUv>& lightmap_uv() const { return uv_.value; }

    /// Throws InputError where no surface can have texels.
    [[nodiscard]] const shlm::PreparedTexels& texels() { return texels(settings_.texels); }
    [[nodiscard]] const shlm::PreparedTexels& texels(const TexelChoice& choice);

    [[nodiscard]] const common::CoveringSurfaces& covers();

    [[nodiscard]] const common::RayScene& rays() const { return *rays_; }

    /// Returns the lights, to sample direct light.
    [[nodiscard]] const common::reference::Lights& lights();

    /// Return the costs of: texels(choice), with the search for lightmap coordinates and surfaces; the same
    /// with the tree over texels, whose bytes are counted in each map; covers().
    [[nodiscard]] Preparation preparation_of_texels(const TexelChoice& choice);
    [[nodiscard]] Preparation preparation_of_texel_tree(const TexelChoice& choice);
    [[nodiscard]] Preparation preparation_of_covers();

  private:
    /// A value and the wall time of making it.
    template <class Value>
    struct Timed {
        common::Stopwatch watch;
        Value value;
        double seconds;

        template <class Make>
        explicit Timed(Make make) : value(make()), seconds(watch.seconds()) {}
    };

    struct TimedTexels {
        Timed<shlm::PreparedTexels> made;
        double tree_seconds = 0;  ///< 0 until the tree is made

        template <class Make>
        explicit TimedTexels(Make make) : made(make) {}
    };

    [[nodiscard]] const Timed<common::SurfacePieces>& pieces();
    [[nodiscard]] TimedTexels& timed_texels(const TexelChoice& choice);

    const common::Scene* scene_;
    const common::RayScene* rays_;
    ContenderSettings settings_;
    Timed<std::vector<shlm::LightmapUv>> uv_;
    std::vector<std::string> trouble_;
    std::optional<Timed<common::SurfacePieces>> pieces_;
    std::map<std::pair<std::size_t, shlm::TexelPlacement>, TimedTexels> texels_;
    std::optional<Timed<common::CoveringSurfaces>> covers_;
    std::optional<common::reference::Lights> lights_;
};

}  // namespace bench
