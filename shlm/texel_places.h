// Where surface points lie among the texels, for finished maps: in a quarter of the bytes that taking hits
// needs.
#pragma once

#include <optional>
#include <vector>

#include "shlm/texel_layout.h"

namespace shlm {

/// Of one surface point.
struct TexelPlace {
    std::uint32_t region;  ///< index into the layout's
    bool back;             ///< on the region's second rectangle
    common::Vec2 at;       ///< in texels of the rectangle

    /// Column and row of its texel in that region.
    [[nodiscard]] std::uint32_t column(const TexelRegion& in) const { return texel_along(at.x, in.width); }
    [[nodiscard]] std::uint32_t row(const TexelRegion& in) const { return texel_along(at.y, in.height); }
};

/// 16 bytes per triangle: its corners are rounded to 2^-16 of their region's width and height, a hundredth of
/// a texel in regions of 655.
class TexelPlaces {
  public:
    explicit TexelPlaces(const TexelLayout& layout);

    /// Nothing where the point has no texel.
    [[nodiscard]] std::optional<TexelPlace> find(const common::SurfacePoint& point) const {
        const Triangle& triangle = triangles_[point.surface.triangle];
        if (triangle.region == no_region) return std::nullopt;
        const TexelRegion& in = regions_[triangle.region];
        if (!point.front && !in.both_faces) return std::nullopt;
        const auto along = [&](std::size_t axis, std::uint32_t texels) {
            const float a = triangle.corner[axis], b = triangle.corner[2 + axis],
                        c = triangle.corner[4 + axis];
            return (a + point.surface.u * (b - a) + point.surface.v * (c - a)) *
                   (static_cast<float>(texels) / 0xffff);
        };
        return TexelPlace{triangle.region, !point.front, {along(0, in.width), along(1, in.height)}};
    }

    [[nodiscard]] const TexelRegion& region(const TexelPlace& place) const { return regions_[place.region]; }
    [[nodiscard]] std::size_t region_count() const { return regions_.size(); }

    [[nodiscard]] std::size_t bytes() const {
        return regions_.capacity() * sizeof(TexelRegion) + triangles_.capacity() * sizeof(Triangle);
    }

  private:
    static constexpr std::uint32_t no_region = 0xffffffff;

    struct Triangle {
        std::array<std::uint16_t, 6> corner{};  ///< x, y of each
        std::uint32_t region = no_region;
    };

    std::vector<TexelRegion> regions_;
    std::vector<Triangle> triangles_;  ///< one per triangle of the scene
};

}  // namespace shlm
