// From a method's filled sink to its finished map.
#pragma once

#include <functional>
#include <memory>

#include "bench/app/methods.h"
#include "common/tracer/trace_photons.h"
#include "shlm/adaptive_map.h"

namespace bench {

/// A light map of any kind. There are dozens, by basis and number; behind this one call they are compiled
/// once.
class FinishedLightMap {
  public:
    template <common::IrradianceEstimator Map>
    explicit FinishedLightMap(Map map) : bytes_(map.bytes()) {
        const auto kept = std::make_shared<const Map>(std::move(map));
        irradiance_ = [kept](const common::SurfacePoint& point) { return kept->irradiance(point); };
    }

    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const {
        return irradiance_(point);
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    std::function<common::Rgb(const common::SurfacePoint&)> irradiance_;
    std::size_t bytes_;
};

static_assert(common::IrradianceEstimator<FinishedLightMap>);

/// What adaptive maps of all errors are made from.
[[nodiscard]] shlm::BlockSearch search_blocks(const shlm::Sink<shlm::AdaptiveModel>& sink,
                                              const common::TraceReport& trace);

/// Of a method that makes one. `layout`: of the sink's texels.
[[nodiscard]] shlm::AdaptiveMap adaptive_map(const ShlmMethod& method, const shlm::BlockSearch& search,
                                             const shlm::TexelLayout& layout);

/// What the method makes of a light map's sums.
template <class Model>
[[nodiscard]] FinishedLightMap finished_map(const ShlmMethod& method, const shlm::Sink<Model>& sink,
                                            const common::TraceReport& trace);

/// The finished map of any method. The sink is used up.
template <class Model>
[[nodiscard]] FinishedLightMap finished_map(const Method& method, shlm::Sink<Model>&& sink,
                                            const common::TraceReport& trace) {
    return finished_map(*method.light_map(), sink, trace);
}
template <common::MapSink Sink>
[[nodiscard]] auto finished_map(const Method&, Sink&& sink, const common::TraceReport& trace) {
    return common::finish_map(std::move(sink), trace);
}

}  // namespace bench
