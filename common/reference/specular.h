// Incident directions of the light that a mirror or glass sends along a given direction.
#pragma once

#include <optional>

#include "common/scene/surface_point.h"

namespace common::reference {

/// Light that arrives at a specular surface and leaves it along a given direction.
struct SpecularArrival {
    Vec3 towards;           ///< unit, from the surface to where the light comes from
    Vec3 geometric_normal;  ///< unit, on the side from which the light comes
    double factor;  ///< outgoing over incident radiance, without the tint, over the probability of this
                    ///< arrival
    double index_ratio_sq;  ///< (index where it leaves / index where it arrives)^2, included in `factor`
    bool straight = false;  ///< through a thin sheet, as if it were not there
};

/// Returns the fraction of unpolarised light that a smooth boundary reflects, for the cosine of incidence and
/// the index of the far side over that of the near one (Cook and Torrance, "A Reflectance Model for Computer
/// Graphics", 1982).
[[nodiscard]] double reflected_fraction(double cosine, double index_ratio);

/// Returns the same for a sheet without thickness, of a material with this index: its two boundaries with all
/// reflections between them.
[[nodiscard]] double reflected_by_sheet(double cosine, double index);

/// Returns the fraction of light along `leaving` (unit, away from the surface) that a thin sheet transmits
/// without bending, without the tint; 0 for all other surfaces.
[[nodiscard]] double passed_straight(const Scene& scene, const SurfaceId& surface, const Vec3& leaving);

/// Samples one of the arrivals that a specular surface sends along `leaving` (unit, away from the surface) by
/// `uniform` in (0, 1). Returns nothing if there is none.
///
/// This is the exact adjoint of the photon tracer's scattering of flux. Light is deflected about the smooth
/// vertex normal, unless that sends it through the wrong side of the triangle, and no light is lost. Where
/// the smooth normal is not the triangle's own, this scales radiance by the ratio of the cosines with the
/// geometric normal (Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 5.3).
/// Only arrivals about both normals together find all of the light. Radiance in a medium is proportional to
/// the square of its index.
[[nodiscard]] std::optional<SpecularArrival> specular_arrival(const Scene& scene, const SurfaceId& surface,
                                                              const Vec3& leaving, double uniform);

}  // namespace common::reference
