// Finds the texture coordinates that can serve as lightmap coordinates, and their defects.
#pragma once

#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace shlm {

/// Triangles with unusable coordinates, and their area.
struct UselessUv {
    std::vector<std::uint32_t> triangle;  ///< of the scene, in rising order
    double area = 0;                      ///< world units squared, one side
};

/// The coordinates of one mesh instance. They are its own: instances may all use the same unit square.
struct LightmapUv {
    int texcoord_set = -1;        ///< 1, or a valid 0, or -1: none
    Imath::Box2f bounds;          ///< of the coordinates, without the collapsed ones
    double covered_fraction = 0;  ///< of `bounds`, by its triangles; places that two share count once
    double covered_apart = 0;     ///< the same without `overlapping`
    double area = 0;              ///< world units squared, one side
    double overlapping_area =
        0;  ///< part of `area` whose coordinates another triangle of the instance uses too

    /// Triangles without area in coordinates, or with less than a thousandth of the instance's median ratio
    /// of area in coordinates to area in the world. They would have no texels, or next to none.
    UselessUv collapsed;

    /// Triangles of islands that overlap themselves, or another island of a larger area.
    UselessUv overlapping;

    /// Returns the triangles of `instance` that the coordinates place: all except the collapsed ones and,
    /// unless `with_overlapping`, the overlapping ones.
    [[nodiscard]] std::vector<std::uint32_t> placed_triangles(const common::MeshInstance& instance,
                                                              bool with_overlapping) const;

    /// Returns the collapsed and the overlapping ones.
    [[nodiscard]] std::vector<std::uint32_t> useless_triangles() const;

    /// Returns whether the coordinates can place at least half of the area and fill at least a tenth of their
    /// rectangle. Otherwise they were not made for a lightmap.
    [[nodiscard]] bool is_lightmap() const;
};

/// Examines every instance with a diffuse material. Other instances get no set, as nothing is stored on them.
/// TEXCOORD_1 is taken as it is. TEXCOORD_0 is taken only if it is a lightmap, lies in the unit square and
/// does not overlap, since most files use it for repeating textures.
[[nodiscard]] std::vector<LightmapUv> find_lightmap_uv(const common::Scene& scene);

/// Returns, for texels by coordinates alone, one line for each kind of defect: missing, collapsed or
/// overlapping coordinates, with the area and what to do about it.
[[nodiscard]] std::vector<std::string> describe_lightmap_trouble(const common::Scene& scene,
                                                                 const std::vector<LightmapUv>& uv);

/// Returns, for texels by coordinates where these are good, one line with the areas that have texels by face
/// in spite of lightmap coordinates, and why; none if there are no such areas.
[[nodiscard]] std::vector<std::string> describe_useless_uv(const common::Scene& scene,
                                                           const std::vector<LightmapUv>& uv);

}  // namespace shlm
