// The smallest scene that has a light map: a quad that is one texel.
#pragma once

#include <span>

#include "bench/experiments/bases/environment.h"
#include "common/tracer/hit_batch.h"
#include "shlm/layout/prepared_texels.h"

namespace bench::bases {

class OneTexel {
  public:
    OneTexel();

    [[nodiscard]] const shlm::PreparedTexels& prepared() const { return prepared_; }

    /// One photon for each arrival, with the flux that gives the texel that irradiance; W, one photon
    /// emitted.
    [[nodiscard]] common::HitBatch photons_of(std::span<const Arrival> arrivals) const;

    /// A point of the texel with a bent normal. The geometric normal is +z.
    [[nodiscard]] common::SurfacePoint point_with(const common::Vec3& shading_normal) const;

  private:
    common::Scene scene_;
    shlm::PreparedTexels prepared_;
};

}  // namespace bench::bases
