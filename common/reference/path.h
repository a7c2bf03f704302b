// One path from a visible point to the light: an estimate of the point's irradiance.
#pragma once

#include "common/reference/lights.h"
#include "common/reference/strata.h"
#include "common/tracer/ray_scene.h"

namespace common::reference {

/// Default limit of the surfaces on a path, including the visible one. The photon tracer ends a photon after
/// as many, so that the two agree even in a room of perfect mirrors.
inline constexpr int max_surfaces = 4096;

/// Parts of the light that reaches a point. `direct` comes from a light straight, or through holes and thin
/// sheets; `indirect` is all the rest, what mirrors and glass deflect included. The photon tracer divides its
/// hits alike (RecordedHits).
enum class LightPart { all, direct, indirect };

/// Returns an unbiased estimate of the irradiance at `point` for its shading normal, from all directions
/// above the surface, W/m^2. The light may take any number of diffuse reflections, mirrors, glass and holes.
///
/// Every diffuse surface combines next event estimation, straight through holes and thin sheets, with
/// cosine-weighted directions, which hit area lights too. The balance heuristic weights the two (Veach and
/// Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995). It does not find
/// point, spot and directional lights through mirrors and glass, except straight through thin sheets. `first`
/// has the random numbers for the point itself, `stream` all others. A path ends at `most_surfaces`. For the
/// same numbers, the estimates of the two parts add up to that of all light.
[[nodiscard]] Imath::V3d sample_irradiance(const RayScene& rays, const Lights& lights,
                                           const SurfacePoint& point, const FirstNumbers& first,
                                           RandomStream& stream, int most_surfaces = max_surfaces,
                                           LightPart part = LightPart::all);

}  // namespace common::reference
