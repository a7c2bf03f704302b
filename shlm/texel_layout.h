// Where the texels are: regions of the light map for the mesh instances, and the texel under a surface point.
#pragma once

#include <span>
#include <vector>

#include "common/core/huge_pages.h"
#include "common/scene/surface_point.h"
#include "shlm/lightmap_uv.h"

namespace shlm {

inline constexpr std::uint32_t no_texel = 0xffffffff;

/// One mesh instance's rectangle of texels, over the bounds of its lightmap coordinates; row by row from
/// `first_texel`. Surfaces whose material shows both faces have a second rectangle right behind the first for
/// their backs.
struct TexelRegion {
    std::uint32_t first_texel = 0;
    std::uint32_t width = 0, height = 0;  ///< 0: the instance has no texels
    bool both_faces = false;

    [[nodiscard]] std::uint32_t texels_per_face() const { return width * height; }
};

/// Everything that finding a hit's texel needs to know of its triangle, on one cache line.
struct alignas(64) TriangleTexels {
    common::Vec2 corner, edge_u,
        edge_v;           ///< lightmap position = corner + u edge_u + v edge_v, in texels of the region
    common::Vec3 normal;  ///< unit, front
    std::uint32_t first_texel = 0;
    std::uint32_t width = 0, height = 0;  ///< 0: hits on this triangle have no texel
    bool both_faces = false;
};

class TexelLayout {
  public:
    /// Gives each instance texels in proportion to its area in the world, `wanted_texels` in all as nearly as
    /// whole rectangles allow, never fewer than one each. Texels are as square in the world as the
    /// coordinates allow.
    TexelLayout(const common::Scene& scene, std::span<const LightmapUv> uv, std::size_t wanted_texels);

    [[nodiscard]] std::span<const TexelRegion> regions() const { return regions_; }

    /// Texels of all regions, those included that no triangle covers.
    [[nodiscard]] std::size_t texel_count() const { return texel_count_; }

    [[nodiscard]] const TriangleTexels& triangle(std::uint32_t index) const { return triangles_[index]; }

    [[nodiscard]] std::size_t bytes() const {
        return triangles_.capacity() * sizeof(TriangleTexels) + regions_.capacity() * sizeof(TexelRegion);
    }

  private:
    std::vector<TexelRegion> regions_;       ///< one per mesh instance
    common::HugePageVector<TriangleTexels> triangles_;  ///< one per triangle of the scene
    std::size_t texel_count_ = 0;
};

/// Index of the texel that the point lies in; `front` says on which face.
[[nodiscard]] inline std::uint32_t texel_at(const TriangleTexels& triangle, float u, float v, bool front) {
    const common::Vec2 at = triangle.corner + triangle.edge_u * u + triangle.edge_v * v;
    const auto clamp_to = [](float value, std::uint32_t count) {
        return static_cast<std::uint32_t>(
            std::clamp(static_cast<int>(value), 0, static_cast<int>(count) - 1));
    };
    const std::uint32_t back = front ? 0 : triangle.width * triangle.height;
    return triangle.first_texel + back + clamp_to(at.y, triangle.height) * triangle.width +
           clamp_to(at.x, triangle.width);
}

}  // namespace shlm
