// The chart that a mesh instance's lightmap coordinates describe.
#pragma once

#include "shlm/layout/lightmap_uv.h"
#include "shlm/layout/texel_chart.h"

namespace shlm {

/// Of the triangles that the coordinates place, the overlapping ones among them or not. The rectangle is that
/// around the coordinates; its sides in the world are those that make texels as square there as the
/// coordinates allow. `uv.texcoord_set` is 0 or 1.
[[nodiscard]] TexelChart uv_chart(const common::Scene& scene, const common::MeshInstance& instance,
                                  const LightmapUv& uv, bool with_overlapping);

}  // namespace shlm
