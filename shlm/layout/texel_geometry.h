// The part of the surface that each texel covers, exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "common/scene/surface_pieces.h"
#include "shlm/layout/texel_layout.h"

namespace shlm {

/// The part of the surface that lies in one texel, summed over all triangles that reach into it.
struct TexelGeometry {
    float area = 0;                ///< world units squared; 0: no triangle covers the texel
    common::Vec3 center{0, 0, 0};  ///< centroid of the covered part
    common::Vec3 normal{0, 0, 0};  ///< mean over the covered part, out of the texel's face: unit, or 0 if the
                                   ///< normals cancel
    std::uint32_t piece = 0;       ///< surface piece of more than half of the covered part, if there is one;
                                   ///< else any of its pieces
};

/// Returns one entry per texel of the layout. Clips every triangle against every texel that it touches, so
/// that the areas of a chart's texels add up to its surface.
[[nodiscard]] std::vector<TexelGeometry> texel_geometry(const common::Scene& scene, const TexelLayout& layout,
                                                        const common::SurfacePieces& pieces);

/// Returns the width of a texel that is covered completely, world units: the largest of these.
[[nodiscard]] inline double texel_width(std::span<const TexelGeometry> texels) {
    float largest = 0;
    for (const TexelGeometry& texel : texels) largest = std::max(largest, texel.area);
    return std::sqrt(double{largest});
}

}  // namespace shlm
