// A search in a FLANN tree that passes candidates directly to a collector.
#pragma once

#include <flann/algorithms/dist.h>
#include <flann/algorithms/nn_index.h>

#include <cmath>
#include <limits>

#include "common/core/vector.h"
#include "common/point_index/point_index.h"

namespace common {

using FlannDistance = flann::L2_3D<float>;
using FlannTree = flann::NNIndex<FlannDistance>;

/// Adapts a collector and a predicate to FLANN's callback interface.
template <PointCollector Collector, class Accept>
class FlannResultSet final : public flann::ResultSet<float> {
  public:
    FlannResultSet(Collector& collector, Accept accept) : collector_(collector), accept_(accept) {}

    [[nodiscard]] bool full() const override { return collector_.full(); }

    void addPoint(float distance_sq, std::size_t index) override {
        // FLANN reads the reach once per leaf, so most candidates of a leaf are beyond it by now.
        if (distance_sq <= collector_.reach_sq() && accept_(static_cast<std::uint32_t>(index)))
            collector_.offer(distance_sq, static_cast<std::uint32_t>(index));
    }

    /// FLANN drops points that are not strictly nearer. Equally near points must pass, so that the lower
    /// index wins.
    [[nodiscard]] float worstDist() const override {
        return std::nextafter(collector_.reach_sq(), std::numeric_limits<float>::infinity());
    }

  private:
    Collector& collector_;
    Accept accept_;
};

template <PointCollector Collector, class Accept>
void flann_search(const FlannTree& tree, const Vec3& query, Collector& collector, Accept accept) {
    FlannResultSet<Collector, Accept> results(collector, accept);
    flann::SearchParams parameters(flann::FLANN_CHECKS_UNLIMITED);
    // FLANN sums the distance to a cell with rounding errors. This slack keeps it from skipping a cell
    // because of one.
    parameters.eps = -1e-5f;
    tree.findNeighbors(results, &query.x, parameters);
}

}  // namespace common
