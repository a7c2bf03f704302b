// The layout of texels: a region of the light map for each chart, and the texel at a surface point.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/core/huge_pages.h"
#include "common/scene/surface_point.h"
#include "shlm/layout/texel_chart.h"

namespace shlm {

inline constexpr std::uint32_t no_texel = 0xffffffff;

/// One chart's rectangle of texels, row by row from `first_texel`. Surfaces whose material shows both faces
/// have a second rectangle right after the first, for their backs.
struct TexelRegion {
    std::uint32_t first_texel = 0;
    std::uint32_t width = 1, height = 1;
    bool both_faces = false;

    [[nodiscard]] std::uint32_t texels_per_face() const { return width * height; }

    /// Returns the first texel of the front's rectangle, or of the back's.
    [[nodiscard]] std::uint32_t first_texel_of(bool back) const {
        return first_texel + (back ? texels_per_face() : 0);
    }
};

/// Maps a position in the world to one on a region's rectangle.
struct RegionPlane {
    common::Vec3 origin;
    common::Vec3 right, down;  ///< texels per world unit

    [[nodiscard]] common::Vec2 place(const common::Vec3& position) const {
        const common::Vec3 from_origin = position - origin;
        return {from_origin.dot(right), from_origin.dot(down)};
    }
};

/// The data of a triangle that are needed to find a hit's texel, in one cache line.
struct alignas(64) TriangleTexels {
    common::Vec2 corner, edge_u,
        edge_v;           ///< lightmap position = corner + u edge_u + v edge_v, in texels of the region
    common::Vec3 normal;  ///< unit, front
    std::uint32_t first_texel = 0;
    std::uint32_t width = 0, height = 0;  ///< 0: hits on this triangle have no texel
    bool both_faces = false;
};

/// Returns the texels' size, world units: the smallest with which the charts have at most `wanted_texels`.
/// Each chart has at least one for each face.
[[nodiscard]] double texel_size_for(std::span<const TexelChart> charts, std::size_t wanted_texels);

/// Returns the number of texels of the charts at a size.
[[nodiscard]] double texels_at_size(std::span<const TexelChart> charts, double texel_size);

class TexelLayout {
  public:
    /// Gives each chart texels in proportion to its area in the world, `wanted_texels` in total as nearly as
    /// whole rectangles allow. Triangles of the scene that are in no chart have no texels. Throws InputError
    /// if there are more than can be counted.
    TexelLayout(const common::Scene& scene, std::span<const TexelChart> charts, std::size_t wanted_texels);

    /// Returns the layout whose texels are `joined[r]` times as wide and high in region r. Those at a far
    /// border may reach beyond it.
    [[nodiscard]] TexelLayout coarser(std::span<const std::uint32_t> joined) const;

    [[nodiscard]] std::span<const TexelRegion> regions() const { return regions_; }

    /// Returns the planes in the regions' order; none at all if any chart has no plane.
    [[nodiscard]] std::span<const RegionPlane> planes() const { return planes_; }

    /// Returns the number of texels of all regions, including those that no triangle covers.
    [[nodiscard]] std::size_t texel_count() const { return texel_count_; }

    [[nodiscard]] const TriangleTexels& triangle(std::uint32_t index) const { return triangles_[index]; }

    /// Returns the number of triangles of the scene.
    [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }

    [[nodiscard]] std::size_t bytes() const {
        return regions_.capacity() * sizeof(TexelRegion) + planes_.capacity() * sizeof(RegionPlane) +
               triangles_.capacity() * sizeof(TriangleTexels);
    }

    /// Returns the index of the region that a triangle with texels lies in.
    [[nodiscard]] std::size_t region_of(std::uint32_t triangle) const {
        const auto after = std::upper_bound(
            regions_.begin(), regions_.end(), triangles_[triangle].first_texel,
            [](std::uint32_t texel, const TexelRegion& region) { return texel < region.first_texel; });
        return static_cast<std::size_t>(after - regions_.begin()) - 1;
    }

  private:
    std::vector<TexelRegion> regions_;  ///< one per chart
    std::vector<RegionPlane> planes_;
    common::HugePageVector<TriangleTexels> triangles_;  ///< one per triangle of the scene
    std::size_t texel_count_ = 0;
};

/// Returns the column or row of the texel at a position on the rectangle, or of the nearest if rounding moved
/// it beyond the border.
[[nodiscard]] inline std::uint32_t texel_along(float position, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(static_cast<int>(position), 0, static_cast<int>(count) - 1));
}

/// Returns the index of the texel that contains the point; `front` selects the face.
[[nodiscard]] inline std::uint32_t texel_at(const TriangleTexels& triangle, float u, float v, bool front) {
    const common::Vec2 at = triangle.corner + triangle.edge_u * u + triangle.edge_v * v;
    const std::uint32_t back = front ? 0 : triangle.width * triangle.height;
    return triangle.first_texel + back + texel_along(at.y, triangle.height) * triangle.width +
           texel_along(at.x, triangle.width);
}

}  // namespace shlm
