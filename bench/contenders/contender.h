// A contender: a named way to store photons and to estimate irradiance from them.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/contenders/answers.h"
#include "bench/contenders/prepared_scene.h"
#include "bench/contenders/store.h"
#include "common/tracer/photon_source.h"
#include "common/tracer/trace_report.h"

namespace bench {

/// Colour and marker in charts. Charts with many variants of one kind vary the shade.
struct ChartStyle {
    std::string colour;  ///< "#rrggbb"
    std::string marker;  ///< as matplotlib names it
};

struct FinishedMap {
    std::unique_ptr<const Answers> answers;
    double build_seconds;  ///< wall time; work that several maps share is charged to each
};

/// The method that a name stands for: immutable.
class Technique {
  public:
    virtual ~Technique() = default;

    /// Returns the full name, which is the same in every table.
    [[nodiscard]] virtual std::string name() const = 0;

    /// Returns the parts of the name with their meaning, family first: {"family": "photonmap", "engine":
    /// "flann", ...}.
    [[nodiscard]] virtual nlohmann::ordered_json fields() const = 0;
    [[nodiscard]] virtual ChartStyle style() const = 0;

    /// Returns the key of its store: techniques with the same key can share one store.
    [[nodiscard]] virtual std::string store_key() const = 0;

    /// Returns an upper bound for the bytes held at the peak, map and index together, without the scene.
    [[nodiscard]] virtual double needed_bytes(const ContenderSettings& settings,
                                              std::uint64_t hits) const = 0;

    /// Returns the most photons that it can count.
    [[nodiscard]] virtual std::size_t most_photons() const;

    /// Prepares what it needs of the scene, unless that exists already; this is no part of a run. Returns the
    /// cost from when it was made. Throws InputError where the scene does not provide it.
    virtual Preparation prepare(PreparedScene& scene) const = 0;

    /// Returns the texels of the light map, or 0 for other techniques.
    [[nodiscard]] virtual std::size_t texel_count(PreparedScene& scene) const;

    /// Makes an empty store for photons of `source`. `scene` must outlive it.
    [[nodiscard]] virtual std::unique_ptr<Store> make_store(PreparedScene& scene,
                                                            const common::PhotonSource& source) const = 0;

    /// Makes the map of a whole run. `store` belongs to this technique or one with the same key, and takes no
    /// hits afterwards.
    [[nodiscard]] virtual FinishedMap finish(Store& store, const common::TraceReport& trace) const = 0;
};

class LightMapTechnique;
class PhotonMapTechnique;

struct Contender {
    std::string name;  ///< the technique's
    std::shared_ptr<const Technique> technique;

    [[nodiscard]] const Technique* operator->() const { return technique.get(); }

    /// Return null where the technique is of another kind.
    [[nodiscard]] const LightMapTechnique* light_map() const;
    [[nodiscard]] const PhotonMapTechnique* photon_map() const;
};

/// Returns whether one store can serve both.
[[nodiscard]] bool share_store(const Contender& a, const Contender& b);

/// Parses a name. Parts left out at its end take their defaults: "shlm" is shlm/L2/radiance/surface4. Throws
/// InputError, which names the option and what is allowed in place of the wrong part.
[[nodiscard]] Contender parse_contender(const std::string& option, const std::string& name);

/// Parses all names. Returns each contender once, in the order given.
[[nodiscard]] std::vector<Contender> parse_contenders(const std::string& option,
                                                      const std::vector<std::string>& names);

/// Contenders that share one store.
using ContenderGroup = std::vector<Contender>;

/// Groups neighbours that share a store.
[[nodiscard]] std::vector<ContenderGroup> groups_of(const std::vector<Contender>& contenders);

}  // namespace bench
