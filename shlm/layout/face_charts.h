// Charts for surfaces without lightmap coordinates: any mesh can have texels ("no parameterization", the
// future work of Good and Taylor 2005).
#pragma once

#include <span>

#include "common/scene/scene.h"
#include "shlm/layout/texel_chart.h"

namespace shlm {

/// Returns rectangles in the planes of flat patches (flat_patches.h) of one instance's triangles, for texels
/// of this size, world units; `both_faces` as in TexelChart. Triangles keep their shape, and texels of a
/// chart have the same area except at its border. Patches that leave more than half of their rectangle empty
/// are divided. Patches smaller than half a texel share a chart with others within the same cube of a texel's
/// size. The result depends only on the scene and the size.
[[nodiscard]] std::vector<TexelChart> face_charts(const common::Scene& scene,
                                                  std::span<const std::uint32_t> triangles, bool both_faces,
                                                  double texel_size);

}  // namespace shlm
