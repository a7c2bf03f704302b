// Stores that take hits while a run is traced.
#pragma once

#include <span>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"

namespace bench {

struct StoreFacts {
    std::size_t bytes = 0;  ///< while it takes hits
    common::RejectedHits rejected;
    double clamped_share = 0;  ///< of a light map: the fraction of flux removed by clamping cosines
};

/// A PhotonSink with run-time polymorphism; an UnorderedSink if it takes any order. The contracts are the
/// same.
class Store {
  public:
    virtual ~Store() = default;

    virtual void consume(std::span<const common::HitBatch> wave) = 0;

    [[nodiscard]] virtual bool takes_any_order() const { return false; }

    /// Adds hits from several threads at once. Only for stores that take any order.
    virtual void add(const common::HitBatch& hits);

    /// Computes the facts by visiting everything stored: for the end of a run.
    [[nodiscard]] virtual StoreFacts facts() const = 0;
};

}  // namespace bench
