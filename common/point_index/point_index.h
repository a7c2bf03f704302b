// The concept of an index over points, and its simplest model.
#pragma once

#include <concepts>
#include <cstddef>

#include "common/core/vector.h"
#include "common/point_index/nearest_set.h"

namespace common {

inline constexpr auto accept_all = [](std::uint32_t) { return true; };

/// Offers to a PointCollector all points that could belong to it and that `accept(index)` admits. Other
/// points take no place: the k nearest are the k nearest of those admitted.
template <class I>
concept PointIndex = requires(const I& index, const Vec3& query, NearestSet& nearest) {
    { index.search(query, nearest, accept_all) } -> std::same_as<void>;
    { index.bytes() } -> std::same_as<std::size_t>;
};

/// Tests every point. The reference in the tests of the other indices.
class BruteForceIndex {
  public:
    explicit BruteForceIndex(std::span<const Vec3> points) : points_(points) {}

    template <PointCollector Collector, class Accept>
    void search(const Vec3& query, Collector& collector, Accept accept) const {
        for (std::uint32_t i = 0; i < points_.size(); ++i)
            if (accept(i)) collector.offer(distance_sq(query, points_[i]), i);
    }

    [[nodiscard]] std::size_t bytes() const { return 0; }

  private:
    std::span<const Vec3> points_;
};

static_assert(PointIndex<BruteForceIndex>);

}  // namespace common
