// Makes a store of a photon map's sink: for the engines' files.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "bench/contenders/photon_map.h"
#include "common/core/stopwatch.h"
#include "common/tracer/trace_photons.h"
#include "photonmap/photon_sinks.h"

namespace bench {

// Upper bounds for the bytes per photon.
inline constexpr double photon_bytes = sizeof(common::Vec3) + sizeof(photonmap::Photon);
inline constexpr double sorting_bytes =
    sizeof(photonmap::Photon) + sizeof(std::uint32_t);  // beside the photons

/// Returns the peak bytes per photon if photons are sorted and then indexed.
[[nodiscard]] constexpr double sorted_and_indexed(double index_bytes) {
    return photon_bytes + std::max(sorting_bytes, index_bytes);
}

/// Sorts and indexes the photons once, at the first finish.
template <common::MapSink Sink>
class SinkStore final : public PhotonMapStore {
  public:
    SinkStore(const common::Scene& scene, const photonmap::GatherSettings& gather,
              const common::CoveringSurfaces* covers)
        : max_radius_(gather.max_radius), sink_(std::in_place, scene, gather, covers) {}

    void consume(std::span<const common::HitBatch> wave) override { sink_->consume(wave); }

    StoreFacts facts() const override {
        return sink_ ? StoreFacts{sink_->bytes(), sink_->rejected()} : facts_;
    }

    FinishedMap finish(const photonmap::PhotonSelection& selection, photonmap::Kernel kernel,
                       const common::TraceReport& trace) override {
        if (sink_) {
            facts_ = facts();
            const common::Stopwatch build;
            map_.emplace(common::finish_map(*std::exchange(sink_, std::nullopt), trace));
            build_seconds_ = build.seconds();
        }
        return {answers_of(map_->with_gather({selection, kernel, max_radius_})), build_seconds_};
    }

  private:
    using Map = decltype(common::finish_map(std::declval<Sink>(), common::TraceReport{}));

    float max_radius_;
    std::optional<Sink> sink_;  ///< until it is finished
    std::optional<Map> map_;
    StoreFacts facts_;
    double build_seconds_ = 0;
};

template <common::MapSink Sink>
[[nodiscard]] std::unique_ptr<PhotonMapStore> make_photon_map_store(const common::Scene& scene,
                                                                    const photonmap::GatherSettings& gather,
                                                                    const common::CoveringSurfaces* covers) {
    return std::make_unique<SinkStore<Sink>>(scene, gather, covers);
}

}  // namespace bench
