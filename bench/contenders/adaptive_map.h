// Light maps whose block sizes adapt to the light.
#pragma once

#include "bench/contenders/light_map.h"
#include "shlm/adaptive/adaptive_map.h"

namespace bench {

/// Named shlm / aPERCENT / normalised / own bilinear [/ uv face] [/ tTEXELS].
class AdaptiveLightMap final : public LightMapTechnique {
  public:
    AdaptiveLightMap(const TexelSetting& setting, double wanted_error_percent)
        : LightMapTechnique(setting), wanted_error_percent_(wanted_error_percent) {}

    /// Returns the map as its own type, for callers that need more than irradiance.
    [[nodiscard]] shlm::AdaptiveMap map_of(Store& store, const common::TraceReport& trace) const;

    std::string name() const override;
    nlohmann::ordered_json fields() const override;
    ChartStyle style() const override { return {"#111111", "*"}; }
    double needed_bytes(const ContenderSettings& settings, std::uint64_t hits) const override;
    FinishedMap finish(Store& store, const common::TraceReport& trace) const override;

  private:
    double wanted_error_percent_;
};

}  // namespace bench
