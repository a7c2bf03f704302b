// Charts for surfaces without lightmap coordinates: any mesh can have texels ("no parameterization", the
// future work of Good and Taylor 2005).
#pragma once

#include <span>

#include "common/scene/scene.h"
#include "shlm/layout/texel_chart.h"

namespace shlm {

/// Rectangles in the planes of flat patches (flat_patches.h) of one instance's triangles, for texels of this
/// size, world units; `both_faces` as TexelChart has it. Triangles keep their shape; texels of a chart have
/// the same area but for what they miss at its border. Patches that leave more than half of their rectangle
/// empty are divided, and such as are smaller than half a texel share a chart with others within the same
/// cube of a texel's size. Depends on the scene and the size alone.
[[nodiscard]] std::vector<TexelChart> face_charts(const common::Scene& scene,
                                                  std::span<const std::uint32_t> triangles, bool both_faces,
                                                  double texel_size);

}  // namespace shlm
