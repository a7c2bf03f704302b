// The charts of a whole scene: by its lightmap coordinates, by its faces, or by what suits each surface.
#pragma once

#include <span>

#include "shlm/layout/lightmap_uv.h"
#include "shlm/layout/texel_chart.h"
#include "shlm/layout/texel_placement.h"

namespace shlm {

/// Return whether an instance's texels are placed by its lightmap coordinates, or by its faces; if neither,
/// it has none. With automatic placement, triangles with unusable coordinates are placed by face.
[[nodiscard]] bool placed_by_uv(const LightmapUv& uv, TexelPlacement placement);
[[nodiscard]] bool placed_by_face(const LightmapUv& uv, TexelPlacement placement);

/// Returns the charts of all diffuse surfaces that have a place. `uv` has one entry for each mesh instance.
/// Charts of faces are made for the texel size that results from `wanted_texels`.
[[nodiscard]] std::vector<TexelChart> texel_charts(const common::Scene& scene, std::span<const LightmapUv> uv,
                                                   TexelPlacement placement, std::size_t wanted_texels);

}  // namespace shlm
