// The places of surface points among the texels, for finished maps. They take a quarter or less of the memory
// that taking hits needs.
#pragma once

#include <optional>
#include <vector>

#include "shlm/layout/texel_layout.h"

namespace shlm {

/// The place of one surface point.
struct TexelPlace {
    std::uint32_t region;  ///< index into the layout's regions
    bool back;             ///< on the region's second rectangle
    common::Vec2 at;       ///< in texels of the rectangle

    /// Column and row of its texel in that region.
    [[nodiscard]] std::uint32_t column(const TexelRegion& in) const { return texel_along(at.x, in.width); }
    [[nodiscard]] std::uint32_t row(const TexelRegion& in) const { return texel_along(at.y, in.height); }
};

/// If all regions have planes, a point's position determines its place: 52 bytes per region and 4 per
/// triangle. Otherwise its triangle's corners do: 16 bytes per region and per triangle. They are rounded to
/// 2^-16 of their region's width and height, a hundredth of a texel in regions of 655 texels.
class TexelPlaces {
  public:
    explicit TexelPlaces(const TexelLayout& layout);

    /// Returns nothing if the point has no texel.
    [[nodiscard]] std::optional<TexelPlace> find(const common::SurfacePoint& point) const {
        const std::uint32_t region = region_of_[point.surface.triangle];
        if (region == no_region) return std::nullopt;
        const TexelRegion& in = regions_[region];
        if (!point.front && !in.both_faces) return std::nullopt;
        return TexelPlace{
            region, !point.front,
            planes_.empty() ? between_corners(point.surface, in) : planes_[region].place(point.position)};
    }

    [[nodiscard]] const TexelRegion& region(const TexelPlace& place) const { return region(place.region); }
    [[nodiscard]] const TexelRegion& region(std::uint32_t index) const { return regions_[index]; }
    [[nodiscard]] std::size_t region_count() const { return regions_.size(); }

    [[nodiscard]] std::size_t bytes() const {
        return regions_.capacity() * sizeof(TexelRegion) + planes_.capacity() * sizeof(RegionPlane) +
               region_of_.capacity() * sizeof(std::uint32_t) + corners_.capacity() * sizeof(Corners);
    }

  private:
    static constexpr std::uint32_t no_region = 0xffffffff;

    /// The corners of a triangle: x, y of each.
    using Corners = std::array<std::uint16_t, 6>;

    [[nodiscard]] common::Vec2 between_corners(const common::SurfaceId& surface,
                                               const TexelRegion& in) const {
        const Corners& corner = corners_[surface.triangle];
        const auto along = [&](std::size_t axis, std::uint32_t texels) {
            const float a = corner[axis], b = corner[2 + axis], c = corner[4 + axis];
            return (a + surface.u * (b - a) + surface.v * (c - a)) * (static_cast<float>(texels) / 0xffff);
        };
        return {along(0, in.width), along(1, in.height)};
    }

    std::vector<TexelRegion> regions_;
    std::vector<RegionPlane> planes_;       ///< of all regions, or none
    std::vector<std::uint32_t> region_of_;  ///< per triangle of the scene
    std::vector<Corners> corners_;          ///< per triangle of the scene; none if there are planes
};

}  // namespace shlm
