// A uniform grid of points, for searches within one known radius.
#pragma once

#include <Imath/ImathBox.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vector.h"
#include "common/point_index/point_index.h"

namespace photonmap {

/// The cells: cubes over the points' bounding box, numbered along x first, then y, then z.
///
/// Their side is the radius of the searches, so that a ball intersects at most three cells in each direction.
/// It is larger if that would make more cells than twice the points.
class GridCells {
  public:
    /// `points` must be finite; `radius` is in their unit and may have any value. Throws InputError for more
    /// points than a GridIndex holds.
    GridCells(std::span<const common::Vec3> points, float radius);

    [[nodiscard]] std::size_t count() const { return size_[0] * size_[1] * size_[2]; }

    [[nodiscard]] std::size_t of(const common::Vec3& point) const {
        return (along(2, point.z) * size_[1] + along(1, point.y)) * size_[0] + along(0, point.x);
    }

    /// Returns the cell's number along one axis, that of the nearest cell for a point outside. Never
    /// decreases with `at`, in spite of rounding.
    [[nodiscard]] std::size_t along(int axis, double at) const {
        const double cell = (at - minimum_[axis]) * cells_per_unit_;
        return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(size_[axis] - 1)));
    }

    /// Returns the first cell of a row along x.
    [[nodiscard]] std::size_t row(std::size_t y, std::size_t z) const {
        return (z * size_[1] + y) * size_[0];
    }

    /// Returns the points' indices sorted by cell; points in the same cell keep their order. A counting sort,
    /// with the threads of the calling arena; the order does not depend on their number.
    [[nodiscard]] std::vector<std::uint32_t> order(std::span<const common::Vec3> points) const;

  private:
    double minimum_[3] = {0, 0, 0};
    double cells_per_unit_ = 1;
    std::size_t size_[3] = {1, 1, 1};  ///< cells along each axis
};

/// Exact for any search; fast if the reach is about the radius that the cells were made for.
class GridIndex {
  public:
    /// Indices are 32 bits wide.
    static constexpr std::size_t max_points = 0xffffffff;

    /// `points` must outlive the index, be finite, and be sorted by the cells, which were made for them.
    /// Throws InputError for more than max_points and std::logic_error for another order.
    GridIndex(std::span<const common::Vec3> points, const GridCells& cells);

    template <common::PointCollector Collector, class Accept>
    void search(const common::Vec3& query, Collector& collector, Accept accept) const {
        // The slack allows for the rounding of the squared distances.
        const double reach = std::sqrt(double{collector.reach_sq()}) * (1 + 1e-6);
        const auto first = [&](int axis) { return cells_.along(axis, double{query[axis]} - reach); };
        const auto last = [&](int axis) { return cells_.along(axis, double{query[axis]} + reach); };
        const std::size_t x0 = first(0), x1 = last(0), y0 = first(1), y1 = last(1), z1 = last(2);
        for (std::size_t z = first(2); z <= z1; ++z)
            for (std::size_t y = y0; y <= y1; ++y) {
                // Cells that are neighbours in x are contiguous.
                const std::size_t row = cells_.row(y, z);
                for (std::uint32_t i = begins_[row + x0]; i < begins_[row + x1 + 1]; ++i) {
                    const float d = common::distance_sq(query, points_[i]);
                    if (d <= collector.reach_sq() && accept(i)) collector.offer(d, i);
                }
            }
    }

    [[nodiscard]] std::size_t bytes() const { return begins_.capacity() * sizeof(std::uint32_t); }

  private:
    std::span<const common::Vec3> points_;
    GridCells cells_;
    std::vector<std::uint32_t> begins_;  ///< first point of each cell, and the end of the last one
};

static_assert(common::PointIndex<GridIndex>);

}  // namespace photonmap
