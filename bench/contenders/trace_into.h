// One trace fills any number of stores.
#pragma once

#include <span>
#include <vector>

#include "bench/contenders/contender.h"
#include "common/tracer/trace_photons.h"

namespace bench {

struct StoresTrace {
    common::TraceReport report;          ///< its sink_seconds are all stores' together
    std::vector<double> insert_seconds;  ///< of each store, which add up to them; wall time
};

/// What is traced.
struct TracedRun {
    const common::RayScene& rays;
    const common::PhotonSource& source;
    std::uint64_t seed;
    common::TraceTarget target;
    common::TraceProgress progress{};
    common::TraceReport so_far{};  ///< gone on from
};

/// Each thread gives its hits to stores that take any order while they are in its cache; the others get
/// waves. Stores of both kinds are filled by two traces of the same photons, as each is filled alone; the
/// report is of the first then. The stores get hits in turns, a block or a wave each.
[[nodiscard]] StoresTrace trace_into(std::span<Store* const> stores, const TracedRun& run);
[[nodiscard]] common::TraceReport trace_into(Store& store, const TracedRun& run);

/// The same without a store.
[[nodiscard]] common::TraceReport trace_into_nothing(const TracedRun& run);

/// One store for several contenders, with what it took to fill it.
struct FilledStore {
    std::unique_ptr<Store> store;
    ContenderGroup contenders;
    double making_room_seconds = 0;  ///< a light map's sums are there from the start
    double insert_seconds = 0;

    FilledStore(ContenderGroup group, PreparedScene& scene, const common::PhotonSource& source);
};

/// Adds to each store's insert_seconds.
[[nodiscard]] common::TraceReport trace_into(std::span<FilledStore> stores, const TracedRun& run);

}  // namespace bench
