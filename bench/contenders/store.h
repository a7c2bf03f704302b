// What takes hits while a run is traced.
#pragma once

#include <span>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"

namespace bench {

struct StoreFacts {
    std::size_t bytes = 0;  ///< held while it takes hits
    common::RejectedHits rejected;
    double clamped_share = 0;  ///< of a light map: the part of the light that clamping cosines took
};

/// A PhotonSink at run time, and an UnorderedSink where it takes any order; with the same contracts.
class Store {
  public:
    virtual ~Store() = default;

    virtual void consume(std::span<const common::HitBatch> wave) = 0;

    [[nodiscard]] virtual bool takes_any_order() const { return false; }

    /// Of stores that take any order: from several threads at once.
    virtual void add(const common::HitBatch& hits);

    /// Goes through all that is stored: for the end of a run.
    [[nodiscard]] virtual StoreFacts facts() const = 0;
};

}  // namespace bench
