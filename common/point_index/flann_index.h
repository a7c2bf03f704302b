// FLANN's kd-trees as point indices.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "common/core/vector.h"
#include "common/point_index/flann_search.h"

namespace common {

/// FLANN counts points with int.
inline constexpr std::size_t max_flann_points = 0x7fffffff;

/// KDTreeSingleIndex: built once over all points, exact.
class FlannIndex {
  public:
    /// `points` must outlive the index and be finite, as FLANN does not terminate on NaN. Throws InputError
    /// for more than max_flann_points.
    explicit FlannIndex(std::span<const Vec3> points);

    template <PointCollector Collector, class Accept>
    void search(const Vec3& query, Collector& collector, Accept accept) const {
        if (tree_) flann_search(*tree_, query, collector, accept);
    }

    /// Bytes measured at the allocator: FLANN's own usedMemory() leaves out more than half and overflows at 2
    /// GiB.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    std::unique_ptr<FlannTree> tree_;  ///< null if there are no points
    std::size_t bytes_ = 0;
};

/// KDTreeIndex with one tree. It grows point by point (FLANN's addPoints), and is rebuilt whenever it has
/// doubled.
///
/// Its search is not exact in three dimensions. FLANN bounds the distance to a cell by the sum over all
/// planes on the way. This is too large if two of them cut the same axis, so that some cells are skipped. Nor
/// is it repeatable: FLANN shuffles the points with std::random_device at every build.
class FlannIncrementalIndex {
  public:
    /// Inserts `points`, which take the next indices. They must be finite and keep their addresses while the
    /// index lives.
    void add(std::span<const Vec3> points);

    template <PointCollector Collector, class Accept>
    void search(const Vec3& query, Collector& collector, Accept accept) const {
        if (tree_) flann_search(*tree_, query, collector, accept);
    }

    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    std::unique_ptr<FlannTree> tree_;
    std::size_t size_ = 0;
    std::size_t bytes_ = 0;
};

}  // namespace common
