// Photon maps: an engine, a selection of photons, and a kernel that weights them.
#pragma once

#include <map>

#include "bench/contenders/contender.h"
#include "photonmap/gather_settings.h"

namespace bench {

/// Stores photons and finds them. The first finish makes the map.
class PhotonMapStore : public Store {
  public:
    [[nodiscard]] virtual FinishedMap finish(const photonmap::PhotonSelection& selection,
                                             photonmap::Kernel kernel, const common::TraceReport& trace) = 0;
};

struct PhotonMapEngine {
    std::string name, purpose;
    ChartStyle style;
    double bytes_per_hit;  ///< at its peak: while the photons are sorted, or with the index
    std::size_t most_photons;
    bool for_one_radius = false;  ///< its index is made for the gather's radius
    bool grows = false;           ///< inserts photons one by one, and builds nothing at the end
    std::unique_ptr<PhotonMapStore> (*make_store)(const common::Scene& scene,
                                                  const photonmap::GatherSettings& gather,
                                                  const common::CoveringSurfaces* covers);
};

/// Registers an engine until the program ends. The file of each engine (engines/) has one of these.
class RegisteredEngine {
  public:
    /// `place`: its unique position in lists; the first is the default.
    RegisteredEngine(int place, const PhotonMapEngine& engine);
};

/// Returns all engines by their place; the first is the default.
[[nodiscard]] const std::map<int, PhotonMapEngine>& photon_map_engines();

/// Named photonmap / ENGINE / kK kFACTORn23 rFRACTION / disc cone epanechnikov.
class PhotonMapTechnique final : public Technique {
  public:
    PhotonMapTechnique(const PhotonMapEngine& engine, const photonmap::PhotonSelection& selection,
                       photonmap::Kernel kernel)
        : engine_(&engine), selection_(selection), kernel_(kernel) {}

    [[nodiscard]] const photonmap::PhotonSelection& selection() const { return selection_; }
    [[nodiscard]] photonmap::Kernel kernel() const { return kernel_; }

    std::string name() const override;
    nlohmann::ordered_json fields() const override;
    ChartStyle style() const override { return engine_->style; }
    std::string store_key() const override;
    double needed_bytes(const ContenderSettings& settings, std::uint64_t hits) const override;
    std::size_t most_photons() const override { return engine_->most_photons; }
    Preparation prepare(PreparedScene& scene) const override { return scene.preparation_of_covers(); }
    std::unique_ptr<Store> make_store(PreparedScene& scene, const common::PhotonSource&) const override;
    FinishedMap finish(Store& store, const common::TraceReport& trace) const override;

  private:
    const PhotonMapEngine* engine_;
    photonmap::PhotonSelection selection_;
    photonmap::Kernel kernel_;
};

}  // namespace bench
