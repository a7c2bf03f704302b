// Fills any number of stores by one trace.
#pragma once

#include <span>
#include <vector>

#include "bench/contenders/contender.h"
#include "common/tracer/trace_photons.h"

namespace bench {

/// The parameters of a trace.
struct TracedRun {
    const common::RayScene& rays;
    const common::PhotonSource& source;
    std::uint64_t seed;
    common::TraceTarget target;
    common::TraceProgress progress{};
    common::TraceReport so_far{};  ///< the run to continue
    common::RecordedHits recorded = common::RecordedHits::all;
};

/// Traces into one store. If it takes any order, each thread passes its hits while they are in its cache.
[[nodiscard]] common::TraceReport trace_into(Store& store, const TracedRun& run);

/// Traces without a store.
[[nodiscard]] common::TraceReport trace_into_nothing(const TracedRun& run);

/// One store for several contenders, with the costs of filling it.
struct FilledStore {
    std::unique_ptr<Store> store;
    ContenderGroup contenders;
    Preparation preparation;         ///< of the scene, not of the run
    double making_room_seconds = 0;  ///< for an empty store: a light map allocates its sums at once
    double insert_seconds = 0;

    /// Returns the seconds that belong to the run: making room and insertion.
    [[nodiscard]] double seconds() const { return making_room_seconds + insert_seconds; }

    FilledStore(ContenderGroup group, PreparedScene& scene, const common::PhotonSource& source);
};

/// Traces into all stores and adds wall time to each one's insert_seconds. The stores get waves in turn,
/// whether or not they take any order. If hits came in blocks, ten light maps would evict each other's sums
/// from the cache and take 1.65 times as long. One light map takes as long by waves as by blocks.
[[nodiscard]] common::TraceReport trace_into(std::span<FilledStore> stores, const TracedRun& run);

}  // namespace bench
