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
    /// `points` must outlive the index and be finite: FLANN does not end on NaN. Throws InputError for more
    /// than max_flann_points.
    explicit FlannIndex(std::span<const Vec3> points);

    template <PointCollector Collector, class Accept>
    void search(const Vec3& query, Collector& collector, Accept accept) const {
        if (tree_) flann_search(*tree_, query, collector, accept);
    }

    /// Measured at the allocator: FLANN's own usedMemory() leaves out more than half and overflows at 2 GiB.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    std::unique_ptr<FlannTree> tree_;  ///< none where there are no points
    std::size_t bytes_ = 0;
};

/// KDTreeIndex with one tree: grows point by point (FLANN's addPoints), rebuilt whenever it has doubled.
///
/// Its search is not exact in three dimensions: FLANN bounds the distance to a cell by the sum over all
/// planes on the way, which is too much where two of them cut the same axis, and so leaves some cells out.
/// Nor is it repeatable: FLANN shuffles the points by std::random_device whenever it builds.
class FlannIncrementalIndex {
  public:
    /// Inserts `points`, which take the next indices. They must stay where they are while the index lives,
    /// and be finite.
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
