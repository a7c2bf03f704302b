// Which texture coordinates can serve as lightmap coordinates, and what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace shlm {

/// Triangles whose coordinates are of no use, with their area.
struct UselessUv {
    std::vector<std::uint32_t> triangle;  ///< of the scene, in rising order
    double area = 0;                      ///< world units squared, one side
};

/// What one mesh instance offers. Its coordinates are its own: instances may all use the same unit square.
struct LightmapUv {
    int texcoord_set = -1;        ///< 1, or a valid 0, or -1: none
    Imath::Box2f bounds;          ///< of the coordinates, but for the collapsed ones
    double covered_fraction = 0;  ///< of `bounds`, by its triangles; what two share is counted once
    double covered_apart = 0;     ///< the same without `overlapping`
    double area = 0;              ///< world units squared, one side
    double overlapping_area =
        0;  ///< part of `area` whose coordinates another triangle of the instance uses too

    /// Without area, or with less than a thousandth of the instance's median area in coordinates for an area
    /// in the world: no texels could lie there, or next to none.
    UselessUv collapsed;

    /// Islands that cover themselves, or others of a larger area.
    UselessUv overlapping;

    /// The triangles that the coordinates place: of `instance`, all but the collapsed ones and, if these are
    /// left out, the overlapping ones.
    [[nodiscard]] std::vector<std::uint32_t> placed_triangles(const common::MeshInstance& instance,
                                                              bool with_overlapping) const;

    /// Collapsed and overlapping ones.
    [[nodiscard]] std::vector<std::uint32_t> useless_triangles() const;

    /// Whether at least half of the area can be placed by the coordinates, and they fill at least a tenth of
    /// their rectangle: else they were not made for a lightmap.
    [[nodiscard]] bool is_lightmap() const;
};

/// Looks at every instance with a diffuse material. Instances without one get no set: nothing is stored on
/// them. TEXCOORD_1 is taken as it is; TEXCOORD_0 only if it is a lightmap, lies in the unit square and does
/// not overlap, since most files use it for repeating textures.
[[nodiscard]] std::vector<LightmapUv> find_lightmap_uv(const common::Scene& scene);

/// For texels by coordinates alone, one line for each kind of trouble: missing, collapsed or overlapping
/// coordinates, with the area and what to do about it.
[[nodiscard]] std::vector<std::string> describe_lightmap_trouble(const common::Scene& scene,
                                                                 const std::vector<LightmapUv>& uv);

/// For texels by coordinates where these are good: one line with the areas that have texels by face although
/// there are lightmap coordinates, and why; none where there are no such.
[[nodiscard]] std::vector<std::string> describe_useless_uv(const common::Scene& scene,
                                                           const std::vector<LightmapUv>& uv);

}  // namespace shlm
