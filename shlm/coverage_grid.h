// How often the triangles of a chart cover each place of the lightmap.
#pragma once

#include <Imath/ImathBox.h>

#include <array>
#include <cstdint>
#include <vector>

#include "common/core/vector.h"

namespace shlm {

using UvTriangle = std::array<common::Vec2, 3>;

/// Sample points at the centres of a square grid over some bounds, each with the number of triangles around
/// it.
class CoverageGrid {
  public:
    /// Between 256 and 512 samples a side, by the number of triangles that will be added. `bounds` has an
    /// area.
    CoverageGrid(const Imath::Box2f& bounds, std::size_t triangle_count);

    void add(const UvTriangle& triangle);

    /// The part of the triangle, from 0 to 1, that another of the added triangles covers too. A triangle
    /// without a sample point takes what holds in the cell of its centroid.
    [[nodiscard]] double shared_part(const UvTriangle& triangle) const;

  private:
    /// Calls `visit(sample)` for every sample strictly inside: samples on an edge belong to neither
    /// neighbour.
    template <class Visit>
    void for_each_sample_in(const UvTriangle& triangle, Visit visit) const;

    /// Column (axis 0) or row (axis 1) of a coordinate.
    [[nodiscard]] int cell_of(float value, int axis) const;

    Imath::Box2f bounds_;
    int size_;                         ///< samples a side
    std::vector<std::uint8_t> users_;  ///< 2 stands for more, too
};

}  // namespace shlm
