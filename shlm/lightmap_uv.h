// Which texture coordinates can serve as lightmap coordinates, and what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace shlm {

/// What one mesh instance offers. Its coordinates are its own: instances may all use the same unit square.
struct LightmapUv {
    int texcoord_set = -1;        ///< 1, or a valid 0, or -1: none
    Imath::Box2f bounds;          ///< of the coordinates
    double covered_fraction = 0;  ///< of `bounds`, by its triangles; overlaps count once
    double area = 0;              ///< world units squared, one side
    double overlapping_area =
        0;  ///< part of `area` whose coordinates another triangle of the instance uses too

    /// Beyond the rounding at chart borders.
    [[nodiscard]] bool overlaps() const { return overlapping_area > 1e-3 * area; }
};

/// Looks at every instance with a diffuse material. Instances without one get no set: nothing is stored on
/// them. TEXCOORD_1 is taken as it is; TEXCOORD_0 only if it lies in the unit square and does not overlap,
/// since most files use it for repeating textures. Overlap is found on a grid of sample points, 256 x 256 to
/// 512 x 512 for each instance, by its triangles.
[[nodiscard]] std::vector<LightmapUv> find_lightmap_uv(const common::Scene& scene);

/// One line for each kind of trouble: missing or overlapping coordinates, with the area and what to do about
/// it.
[[nodiscard]] std::vector<std::string> describe_lightmap_trouble(const common::Scene& scene,
                                                                 const std::vector<LightmapUv>& uv);

}  // namespace shlm
