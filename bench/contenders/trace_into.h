// One trace fills any number of stores.
#pragma once

#include <span>
#include <vector>

#include "bench/contenders/contender.h"
#include "common/tracer/trace_photons.h"

namespace bench {

/// What is traced.
struct TracedRun {
    const common::RayScene& rays;
    const common::PhotonSource& source;
    std::uint64_t seed;
    common::TraceTarget target;
    common::TraceProgress progress{};
    common::TraceReport so_far{};  ///< gone on from
};

/// Where the store takes any order, each thread gives it its hits while they are in its cache.
[[nodiscard]] common::TraceReport trace_into(Store& store, const TracedRun& run);

/// The same without a store.
[[nodiscard]] common::TraceReport trace_into_nothing(const TracedRun& run);

/// One store for several contenders, with what it took to fill it.
struct FilledStore {
    std::unique_ptr<Store> store;
    ContenderGroup contenders;
    Preparation preparation;         ///< the scene's, not the run's
    double making_room_seconds = 0;  ///< a light map's sums are there from the start
    double insert_seconds = 0;

    /// Of the run: making room and insertion.
    [[nodiscard]] double seconds() const { return making_room_seconds + insert_seconds; }

    FilledStore(ContenderGroup group, PreparedScene& scene, const common::PhotonSource& source);
};

/// Adds to each store's insert_seconds, wall time. The stores get waves in turn, in any order or not: block
/// by block, ten light maps drive each other's sums out of the cache and take 1.65 times as long, while one
/// takes as long by waves as by blocks.
[[nodiscard]] common::TraceReport trace_into(std::span<FilledStore> stores, const TracedRun& run);

}  // namespace bench
