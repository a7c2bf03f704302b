// The finished spherical harmonic light map: irradiance from the nearest texels (Good and Taylor 2005).
#pragma once

#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/point_index/flann_index.h"
#include "shlm/accumulator.h"
#include "shlm/texel_geometry.h"

namespace shlm {

/// A texel that a gather can find.
struct Texel {
    common::Vec3 normal;  ///< unit, out of the face
    float area;           ///< world units squared
    /// Coefficients of irradiance by normal: W/m^2 per harmonic.
    std::array<common::Rgb, coefficient_count> irradiance;
};

/// Immutable. Holds the covered texels only; its size does not depend on how many hits they have taken.
class LightMap {
  public:
    /// `sums` and `geometry` have one entry per texel of the same layout; `watts_per_flux` as in
    /// common::MapSink.
    LightMap(const TexelSums& sums, std::span<const TexelGeometry> geometry, float watts_per_flux,
             std::size_t nearest);

    /// Irradiance for the shading normal, W/m^2: the mean over the nearest texels whose face looks the
    /// point's way, weighted by their areas projected onto the point's surface. Never negative: what the
    /// truncated series takes below zero is cut off. Zero where no texel lies within four widths of the
    /// largest one.
    [[nodiscard]] common::Rgb irradiance(const common::SurfacePoint& point) const;

    [[nodiscard]] std::size_t bytes() const {
        return centers_.capacity() * sizeof(common::Vec3) + texels_.capacity() * sizeof(Texel) +
               index_.bytes();
    }

    [[nodiscard]] std::span<const Texel> texels() const { return texels_; }

  private:
    std::vector<common::Vec3> centers_;
    std::vector<Texel> texels_;
    common::FlannIndex index_;
    std::size_t nearest_;
    float max_radius_;  ///< world units
};

/// Irradiance at `normal` from one texel's coefficients, W/m^2; may be negative.
[[nodiscard]] common::Rgb evaluate_irradiance(const Texel& texel, const common::Vec3& normal);

static_assert(common::IrradianceEstimator<LightMap>);

}  // namespace shlm
