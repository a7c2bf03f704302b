// Where the light comes from that a mirror or glass sends along a given direction.
#pragma once

#include <optional>

#include "common/scene/surface_point.h"

namespace common::reference {

/// Light that arrives at a specular surface and leaves it along the direction that was asked for.
struct SpecularArrival {
    Vec3 towards;           ///< unit, from the surface to where the light comes from
    Vec3 geometric_normal;  ///< unit, on the side that it comes from
    double factor;  ///< radiance that leaves, without the tint, over radiance that arrives, over the chance
                    ///< of this arrival
    double index_ratio_sq;  ///< (index where it leaves / index where it arrives)^2, which is part of `factor`
    bool straight = false;  ///< through a thin sheet, as if it were not there
};

/// What fraction of unpolarised light a smooth boundary reflects, for the cosine of incidence and the index
/// of the far side over that of the near one (Cook and Torrance, "A Reflectance Model for Computer Graphics",
/// 1982).
[[nodiscard]] double reflected_fraction(double cosine, double index_ratio);

/// The same of a sheet without thickness, made of what has this index: its two boundaries and all reflections
/// between them.
[[nodiscard]] double reflected_by_sheet(double cosine, double index);

/// What fraction of light leaves a thin sheet along `leaving` (unit, away from the surface) as it has come,
/// without the tint; 0 for all other surfaces.
[[nodiscard]] double passed_straight(const Scene& scene, const SurfaceId& surface, const Vec3& leaving);

/// One of the arrivals that a specular surface sends along `leaving` (unit, away from the surface), chosen by
/// `uniform` in (0, 1); nothing where there is none.
///
/// This is the exact adjoint of what the photon tracer does with flux: light bends about the smooth vertex
/// normal, unless that sends it through the wrong side of the triangle, and none is lost. Where the smooth
/// normal is not the triangle's own, that scales radiance by the ratio of the cosines with the geometric
/// normal (Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 5.3), and it
/// takes an arrival about each normal to find all of the light. Radiance in a medium grows with the square of
/// its index.
[[nodiscard]] std::optional<SpecularArrival> specular_arrival(const Scene& scene, const SurfaceId& surface,
                                                              const Vec3& leaving, double uniform);

}  // namespace common::reference
