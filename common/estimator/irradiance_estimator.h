// The query that every finished map answers.
#pragma once

#include <concepts>
#include <cstddef>

#include "common/scene/surface_point.h"

namespace common {

/// A finished, immutable map that any number of threads may query at once.
template <class M>
concept IrradianceEstimator = requires(const M& map, const SurfacePoint& point) {
    /// Irradiance at the point for its shading normal, W/m^2: not divided by pi, not multiplied by the
    /// albedo.
    { map.irradiance(point) } -> std::same_as<Rgb>;
    /// Memory that the map needs for queries, counted from capacities, bytes.
    { map.bytes() } -> std::same_as<std::size_t>;
};

/// Smallest cosine of incidence that the flux of a hit is divided by. A hit of flux F on area a gives
/// irradiance F / a on the surface, and F / (a cos theta) on a plane that faces the light. The clamp keeps
/// grazing hits from outweighing all others. It darkens uniform light by the fraction min_incident_cosine /
/// 2.
inline constexpr float min_incident_cosine = 1e-3f;

/// Smallest cosine between the normals of two places on the same surface, for a gather: 65 degrees. So
/// photons or texels round a corner, or on the other side of a wall, do not count. Facets of simple shapes
/// meet at 60 or 72 degrees, not near 65, so that rounding a normal does not decide.
inline constexpr float same_surface_cosine = 0.4226183f;

}  // namespace common
