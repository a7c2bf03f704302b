// A spatial index of the covered texels.
#pragma once

#include <span>
#include <vector>

#include "common/point_index/flann_index.h"
#include "shlm/layout/texel_geometry.h"

namespace shlm {

/// Numbers the covered texels in the layout's order. It does not depend on any light, so that one serves all
/// maps with the same texels.
class TexelTree {
  public:
    explicit TexelTree(std::span<const TexelGeometry> texels);
    TexelTree(const TexelTree&) = delete;  // the index points into it
    TexelTree& operator=(const TexelTree&) = delete;

    template <common::PointCollector Collector, class Accept>
    void search(const common::Vec3& query, Collector& collector, Accept accept) const {
        index_.search(query, collector, accept);
    }

    /// Returns the surface piece of a texel (common::SurfacePieces).
    [[nodiscard]] std::uint32_t piece(std::uint32_t number) const { return piece_[number]; }

    /// Returns four widths of the largest texel, world units: every point of a surface has a texel of its own
    /// within that distance.
    [[nodiscard]] float max_radius() const { return max_radius_; }

    /// Returns the memory without the pieces.
    [[nodiscard]] std::size_t bytes() const {
        return center_.capacity() * sizeof(common::Vec3) + index_.bytes();
    }
    [[nodiscard]] std::size_t bytes_of_pieces() const { return piece_.capacity() * sizeof(std::uint32_t); }

  private:
    std::vector<common::Vec3> center_;
    std::vector<std::uint32_t> piece_;
    common::FlannIndex index_;
    float max_radius_;
};

}  // namespace shlm
