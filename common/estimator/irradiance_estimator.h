// What a finished map answers.
#pragma once

#include <concepts>
#include <cstddef>

#include "common/scene/surface_point.h"

namespace common {

/// A finished, immutable map that any number of threads may ask at once.
template <class M>
concept IrradianceEstimator = requires(const M& map, const SurfacePoint& point) {
    /// Irradiance at the point for its shading normal, W/m^2: not divided by pi, not multiplied by the
    /// albedo.
    { map.irradiance(point) } -> std::same_as<Rgb>;
    /// Everything that the answer needs, from capacities.
    { map.bytes() } -> std::same_as<std::size_t>;
};

/// Smallest cosine of incidence that a hit is divided by. A hit of flux F on area a is F / a on the surface,
/// and F / (a cos theta) on a plane that faces the light; the clamp keeps grazing hits from outweighing all
/// others and darkens uniform light by half its value.
inline constexpr float min_incident_cosine = 1e-3f;

/// Two places belong to the same surface, for a gather, if their normals are within 65 degrees: photons or
/// texels round a corner, or on the other side of a wall, do not count. Facets of simple shapes meet at 60 or
/// 72 degrees, not near 65, so that rounding a normal does not decide.
inline constexpr float same_surface_cosine = 0.4226183f;

}  // namespace common
