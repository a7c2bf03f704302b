// One path from a visible point to the light: an estimate of the point's irradiance.
#pragma once

#include "common/reference/lights.h"
#include "common/reference/strata.h"
#include "common/tracer/ray_scene.h"

namespace common::reference {

/// Surfaces on a path, the visible one included, where nothing else is said. The photon tracer gives a photon
/// up after as many, so the two agree even in a room of perfect mirrors.
inline constexpr int max_surfaces = 4096;

/// An unbiased estimate of the irradiance at `point` for its shading normal, from all directions above the
/// surface, W/m^2: light by any number of diffuse reflections, mirrors, glass and holes in between.
///
/// Next event estimation at every diffuse surface, straight through holes and thin sheets, and
/// cosine-weighted directions, which meet area lights too;
/// the balance heuristic weighs the two (Veach and Guibas, "Optimally Combining Sampling Techniques for Monte
/// Carlo Rendering", 1995). Not found: point, spot and directional lights by way of mirrors and glass, but
/// for what comes straight through thin sheets.
/// `first` decides at the point itself, `stream` everywhere else. A path ends at `most_surfaces`.
[[nodiscard]] Imath::V3d sample_irradiance(const RayScene& rays, const Lights& lights,
                                           const SurfacePoint& point, const FirstNumbers& first,
                                           RandomStream& stream, int most_surfaces = max_surfaces);

}  // namespace common::reference
