// The chart that a mesh instance's lightmap coordinates describe.
#pragma once

#include "shlm/layout/lightmap_uv.h"
#include "shlm/layout/texel_chart.h"

namespace shlm {

/// Returns the chart of the triangles that the coordinates place, with or without the overlapping ones. The
/// rectangle is that around the coordinates. Its sides in the world make texels as square there as the
/// coordinates allow. `uv.texcoord_set` must be 0 or 1.
[[nodiscard]] TexelChart uv_chart(const common::Scene& scene, const common::MeshInstance& instance,
                                  const LightmapUv& uv, bool with_overlapping);

}  // namespace shlm
