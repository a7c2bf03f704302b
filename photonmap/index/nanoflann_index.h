// nanoflann's kd-tree as a point index: the library that people would choose today.
#pragma once

#include <cstddef>
#include <memory>
#include <nanoflann.hpp>
#include <span>

#include "common/core/vector.h"
#include "common/point_index/point_index.h"

namespace photonmap {

/// KDTreeSingleIndexAdaptor: built once over all points, exact. It leaves the points where they are and keeps
/// four bytes of each beside its nodes, so that points that are near in space should be near in memory.
class NanoflannIndex {
  public:
    /// Indices are 32 bits wide.
    static constexpr std::size_t max_points = 0xffffffff;

    /// `points` must outlive the index and be finite; best along a Morton curve. Builds with the threads of
    /// the calling arena where the library can (from version 1.5). Throws InputError for more than
    /// max_points.
    explicit NanoflannIndex(std::span<const common::Vec3> points);

    template <common::PointCollector Collector, class Accept>
    void search(const common::Vec3& query, Collector& collector, Accept accept) const {
        if (!tree_) return;
        ResultSet<Collector, Accept> results(collector, accept);
        tree_->index.findNeighbors(results, &query.x, search_parameters());
    }

    /// Measured at the allocator: nanoflann's own usedMemory() overflows at 4 GiB.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    /// The points as nanoflann asks for them, by names of its choice.
    struct Points {
        std::span<const common::Vec3> points;

        [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
        [[nodiscard]] float kdtree_get_pt(std::size_t point, std::size_t axis) const {
            return (&points[point].x)[axis];
        }
        template <class Bounds>
        [[nodiscard]] bool kdtree_get_bbox(Bounds& /*bounds*/) const {
            return false;  // it finds them itself
        }
    };

    using Distance = nanoflann::L2_Simple_Adaptor<float, Points, float, std::uint32_t>;

    struct Tree {
        Points points;  ///< the index refers to it
        nanoflann::KDTreeSingleIndexAdaptor<Distance, Points, 3, std::uint32_t> index;

        explicit Tree(std::span<const common::Vec3> p);
    };

    /// nanoflann's callback interface around a collector and a predicate.
    template <common::PointCollector Collector, class Accept>
    class ResultSet {
      public:
        using DistanceType = float;

        ResultSet(Collector& collector, Accept accept) : collector_(collector), accept_(accept) {}

        [[nodiscard]] bool full() const { return collector_.full(); }
        [[nodiscard]] std::size_t size() const { return 0; }
        void sort() {}

        /// Returns that the search shall go on.
        bool addPoint(float distance_sq, std::uint32_t index) {
            // nanoflann looks at the reach once per leaf, so most candidates of a leaf come too late.
            if (distance_sq <= collector_.reach_sq() && accept_(index)) collector_.offer(distance_sq, index);
            return true;
        }

        /// nanoflann drops what is not strictly nearer; equally near points must come through for the lower
        /// index to win.
        [[nodiscard]] float worstDist() const {
            return std::nextafter(collector_.reach_sq(), std::numeric_limits<float>::infinity());
        }

      private:
        Collector& collector_;
        Accept accept_;
    };

    /// nanoflann adds up the distance to a cell with rounding errors; the slack keeps it from skipping a cell
    /// by one of them.
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

    std::unique_ptr<const Tree> tree_;  ///< none where there are no points
    std::size_t bytes_ = 0;
};

static_assert(common::PointIndex<NanoflannIndex>);

}  // namespace photonmap
