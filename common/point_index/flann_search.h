// One search in a FLANN tree, with the candidates going straight to a collector.
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

/// FLANN's callback interface around a collector and a predicate.
template <PointCollector Collector, class Accept>
class FlannResultSet final : public flann::ResultSet<float> {
  public:
    FlannResultSet(Collector& collector, Accept accept) : collector_(collector), accept_(accept) {}

    [[nodiscard]] bool full() const override { return collector_.full(); }

    void addPoint(float distance_sq, std::size_t index) override {
        // FLANN looks at the reach once per leaf, so most candidates of a leaf come too late.
        if (distance_sq <= collector_.reach_sq() && accept_(static_cast<std::uint32_t>(index)))
            collector_.offer(distance_sq, static_cast<std::uint32_t>(index));
    }

    /// FLANN drops what is not strictly nearer; equally near points must come through for the lower index to
    /// win.
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
    // FLANN adds up the distance to a cell with rounding errors; the slack keeps it from skipping a cell by
    // one of them.
    parameters.eps = -1e-5f;
    tree.findNeighbors(results, &query.x, parameters);
}

}  // namespace common
