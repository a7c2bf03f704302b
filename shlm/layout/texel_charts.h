// The charts of a whole scene: by its lightmap coordinates, by its faces, or by what suits each surface.
#pragma once

#include <span>

#include "shlm/layout/lightmap_uv.h"
#include "shlm/layout/texel_chart.h"
#include "shlm/layout/texel_placement.h"

namespace shlm {

/// Whether an instance's texels lie by its lightmap coordinates, or by its faces. Where neither, it has none.
/// Where coordinates are chosen automatically, triangles that they are useless for lie by face.
[[nodiscard]] bool placed_by_uv(const LightmapUv& uv, TexelPlacement placement);
[[nodiscard]] bool placed_by_face(const LightmapUv& uv, TexelPlacement placement);

/// For all diffuse surfaces that have a place. `uv` has one entry for each mesh instance. Charts of faces are
/// made for the size that `wanted_texels` will have.
[[nodiscard]] std::vector<TexelChart> texel_charts(const common::Scene& scene, std::span<const LightmapUv> uv,
                                                   TexelPlacement placement, std::size_t wanted_texels);

}  // namespace shlm
