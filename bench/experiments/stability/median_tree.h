// A textbook kd-tree, which lacks our handling of equal coordinates.
#pragma once

#include <algorithm>
#include <vector>

#include "common/core/vector.h"

namespace bench::stability {

/// Splits its points at the median along x, y and z in turn (Bentley 1975). Points with equal coordinates may
/// lie on both sides of the plane through them.
class MedianTree {
  public:
    explicit MedianTree(std::vector<common::Vec3> points) : points_(std::move(points)) {
        build(0, points_.size(), 0);
    }

    /// Searches like the indices of common/point_index. All points are accepted; they are numbered by their
    /// positions in the tree.
    template <class Collector, class Accept>
    void search(const common::Vec3& at, Collector& collector, Accept) const {
        search(at, collector, 0, points_.size(), 0);
    }

  private:
    static constexpr std::size_t leaf_size = 8;

    void build(std::size_t begin, std::size_t end, int axis) {
        if (end - begin <= leaf_size) return;
        const std::size_t middle = (begin + end) / 2;
        const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end),
                         [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
        build(begin, middle, (axis + 1) % 3);
        build(middle, end, (axis + 1) % 3);
    }

    template <class Collector>
    void search(const common::Vec3& at, Collector& collector, std::size_t begin, std::size_t end,
                int axis) const {
        if (end - begin <= leaf_size) {
            for (std::size_t i = begin; i < end; ++i)
                collector.offer((points_[i] - at).length2(), static_cast<std::uint32_t>(i));
            return;
        }
        const std::size_t middle = (begin + end) / 2;
        const float beyond = at[axis] - points_[middle][axis];
        const int next = (axis + 1) % 3;
        const auto go = [&](bool upper) {
            upper ? search(at, collector, middle, end, next) : search(at, collector, begin, middle, next);
        };
        go(beyond >= 0);
        if (beyond * beyond <= collector.reach_sq()) go(beyond < 0);
    }

    std::vector<common::Vec3> points_;
};

}  // namespace bench::stability
