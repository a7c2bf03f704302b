// The smallest scene with a light map: a quad that is one texel.
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

    /// Returns one photon per arrival, with the flux in W that gives the texel this irradiance if one photon
    /// is emitted.
    [[nodiscard]] common::HitBatch photons_of(std::span<const Arrival> arrivals) const;

    /// Returns a point of the texel with this shading normal. The geometric normal is +z.
    [[nodiscard]] common::SurfacePoint point_with(const common::Vec3& shading_normal) const;

  private:
    common::Scene scene_;
    shlm::PreparedTexels prepared_;
};

}  // namespace bench::bases
