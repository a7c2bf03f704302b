// Everything about a scene's light map that does not depend on its light.
#pragma once

#include "shlm/normals_in_use.h"
#include "shlm/texel_charts.h"
#include "shlm/texel_geometry.h"

namespace shlm {

/// Made once, used by any number of runs.
struct PreparedTexels {
    TexelLayout layout;
    std::vector<TexelGeometry> geometry;  ///< one per texel of the layout
    std::vector<NormalsInUse> normals;    ///< one per region of the layout

    PreparedTexels(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t texels,
                   TexelPlacement placement = TexelPlacement::uv)
        : layout(scene, texel_charts(scene, uv, placement, texels), texels),
          geometry(texel_geometry(scene, layout)),
          normals(normals_in_use(scene, layout)) {}
};

}  // namespace shlm
