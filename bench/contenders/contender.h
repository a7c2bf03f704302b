// A contender: a way to store photons and to answer with irradiance, by its name.
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

/// Its colour and marker. Charts of many variants of one kind shade them.
struct ChartStyle {
    std::string colour;  ///< "#rrggbb"
    std::string marker;  ///< as matplotlib names it
};

struct FinishedMap {
    std::unique_ptr<const Answers> answers;
    double build_seconds;  ///< wall time; what maps of one store share is charged to each
};

/// What stands behind a name: immutable.
class Technique {
  public:
    virtual ~Technique() = default;

    /// In full: it stays the same in every table.
    [[nodiscard]] virtual std::string name() const = 0;

    /// The name's parts by what they say, family first: {"family": "photonmap", "engine": "flann", ...}.
    [[nodiscard]] virtual nlohmann::ordered_json fields() const = 0;
    [[nodiscard]] virtual ChartStyle style() const = 0;

    /// One store can serve all that have the same.
    [[nodiscard]] virtual std::string store_key() const = 0;

    /// An upper bound for the bytes held at its peak, map and index together; the scene is not in it.
    [[nodiscard]] virtual double needed_bytes(const ContenderSettings& settings,
                                              std::uint64_t hits) const = 0;

    /// Photons that it can count.
    [[nodiscard]] virtual std::size_t most_photons() const;

    /// Makes what it needs of the scene, unless it is there: no part of a run. Says what that took when it
    /// was made. Throws InputError where the scene has not got it.
    virtual Preparation prepare(PreparedScene& scene) const = 0;

    /// Of the light map; 0 where there is none.
    [[nodiscard]] virtual std::size_t texel_count(PreparedScene& scene) const;

    /// Empty, for photons of `source`. `scene` must outlive it.
    [[nodiscard]] virtual std::unique_ptr<Store> make_store(PreparedScene& scene,
                                                            const common::PhotonSource& source) const = 0;

    /// The map of a whole run. `store` is of this technique or of one with the same key, and takes no more
    /// hits.
    [[nodiscard]] virtual FinishedMap finish(Store& store, const common::TraceReport& trace) const = 0;
};

class LightMapTechnique;
class PhotonMapTechnique;

struct Contender {
    std::string name;  ///< the technique's
    std::shared_ptr<const Technique> technique;

    [[nodiscard]] const Technique* operator->() const { return technique.get(); }

    /// Null where it is none.
    [[nodiscard]] const LightMapTechnique* light_map() const;
    [[nodiscard]] const PhotonMapTechnique* photon_map() const;
};

/// Whether one store can serve both.
[[nodiscard]] bool share_store(const Contender& a, const Contender& b);

/// Reads a name; what is left out at its end takes the default: "shlm" is shlm/L2/radiance/surface4. Throws
/// InputError, naming the option and what may stand in the place that is wrong.
[[nodiscard]] Contender parse_contender(const std::string& option, const std::string& name);

/// All of them, each once, in the order given.
[[nodiscard]] std::vector<Contender> parse_contenders(const std::string& option,
                                                      const std::vector<std::string>& names);

/// Contenders that one store serves.
using ContenderGroup = std::vector<Contender>;

/// Neighbours that share a store.
[[nodiscard]] std::vector<ContenderGroup> groups_of(const std::vector<Contender>& contenders);

}  // namespace bench
