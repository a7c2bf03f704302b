// nanoflann's kd-tree as a point index: the library that people would choose today.
#pragma once

#include <cstddef>
#include <memory>
#include <nanoflann.hpp>
#include <span>

#include "common/core/vector.h"
#include "common/point_index/point_index.h"

namespace photonmap {

/// KDTreeSingleIndexAdaptor: built once over all points, exact. It leaves the points where they are and
/// stores four bytes for each beside its nodes. So points that are near in space should be near in memory.
class NanoflannIndex {
  public:
    /// Indices are 32 bits wide.
    static constexpr std::size_t max_points = 0xffffffff;

    /// `points` must outlive the index and be finite; a Morton order is best. Builds with the threads of the
    /// calling arena if the library can (from version 1.5). Throws InputError for more than max_points.
    explicit NanoflannIndex(std::span<const common::Vec3> points);

    template <common::PointCollector Collector, class Accept>
    void search(const common::Vec3& query, Collector& collector, Accept accept) const {
        if (!tree_) return;
        ResultSet<Collector, Accept> results(collector, accept);
        tree_->index.findNeighbors(results, &query.x, search_parameters());
    }

    /// Bytes measured at the allocator: nanoflann's own usedMemory() overflows at 4 GiB.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    /// Gives nanoflann the points, by the names that it expects.
    struct Points {
        std::span<const common::Vec3> points;

        [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
        [[nodiscard]] float kdtree_get_pt(std::size_t point, std::size_t axis) const {
            return (&points[point].x)[axis];
        }
        template <class Bounds>
        [[nodiscard]] bool kdtree_get_bbox(Bounds& /*bounds*/) const {
            return false;  // nanoflann finds them itself
        }
    };

    using Distance = nanoflann::L2_Simple_Adaptor<float, Points, float, std::uint32_t>;

    struct Tree {
        Points points;  ///< the index refers to them
        nanoflann::KDTreeSingleIndexAdaptor<Distance, Points, 3, std::uint32_t> index;

        explicit Tree(std::span<const common::Vec3> p);
    };

    /// Adapts a collector and a predicate to nanoflann's callback interface.
    template <common::PointCollector Collector, class Accept>
    class ResultSet {
      public:
        using DistanceType = float;

        ResultSet(Collector& collector, Accept accept) : collector_(collector), accept_(accept) {}

        [[nodiscard]] bool full() const { return collector_.full(); }
        [[nodiscard]] std::size_t size() const { return 0; }
        void sort() {}

        /// Returns true: the search goes on.
        bool addPoint(float distance_sq, std::uint32_t index) {
            // nanoflann reads the reach once per leaf, so most candidates of a leaf are beyond it by now.
            if (distance_sq <= collector_.reach_sq() && accept_(index)) collector_.offer(distance_sq, index);
            return true;
        }

        /// nanoflann drops points that are not strictly nearer. Equally near points must pass, so that the
        /// lower index wins.
        [[nodiscard]] float worstDist() const {
            return std::nextafter(collector_.reach_sq(), std::numeric_limits<float>::infinity());
        }

      private:
        Collector& collector_;
        Accept accept_;
    };

    /// nanoflann sums the distance to a cell with rounding errors. This slack keeps it from skipping a cell
    /// because of one.
    static constexpr float slack = -1e-5f;
#if NANOFLANN_VERSION < 0x150
    static nanoflann::SearchParams search_parameters() {
        return {0, slack, false};
    }
#else
    static nanoflann::SearchParameters search_parameters() {
        return {slack, false};
    }
#endif

    std::unique_ptr<const Tree> tree_;  ///< null if there are no points
    std::size_t bytes_ = 0;
};

static_assert(common::PointIndex<NanoflannIndex>);

}  // namespace photonmap
