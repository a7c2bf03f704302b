// One timed run of one method: trace, insert, build, gather.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/contenders/contender.h"
#include "bench/setup/query_points.h"
#include "common/tracer/rejected_hits.h"
#include "common/tracer/trace_photons.h"

namespace bench::compare {

/// What a run took and kept. Times are wall seconds.
struct Measurement {
    Preparation preparation;         ///< the scene's, made before the first run
    double making_room_seconds = 0;  ///< for an empty store: a light map's sums are there from the start
    common::TraceReport trace;
    double build_seconds = 0;
    double gather_seconds = 0;  ///< all query points, image order, one thread
    double gather_shuffled_seconds = 0;
    std::size_t bytes = 0;                  ///< finished map with its index
    std::size_t insert_bytes = 0;           ///< the store while it took hits
    std::size_t resident_before_bytes = 0;  ///< of the process: the scene, the texels, the program itself
    std::size_t peak_resident_bytes = 0;    ///< of the process, while this method ran
    bool peak_is_of_this_run = true;  ///< false where the system does not let it be reset: since the start
    common::RejectedHits rejected;
    std::string given_up;        ///< why the run was ended and its memory given back; empty where it was not
    double mean_irradiance = 0;  ///< over the query points and channels, W/m^2: are the answers alike?
};

/// What a run works on.
struct Workload {
    const LoadedScene& scene;
    const common::PhotonSource& source;
    const QueryPoints& queries;
    std::uint64_t seed;
    common::TraceTarget target;
    common::TraceProgress progress;
    std::size_t max_bytes =
        std::numeric_limits<std::size_t>::max();  ///< that the method may add to the process
};

/// Uses the threads of the calling arena for all but the gathers. An interrupted run has trace.interrupted
/// set and nothing after the trace. So has one that grows past max_bytes or finds no more memory, which is
/// looked at after each wave of hits and after the build.
[[nodiscard]] Measurement measure_method(const Contender& contender, PreparedScene& scene,
                                         const Workload& workload);

/// The same trace without a store.
[[nodiscard]] common::TraceReport measure_null_sink(const Workload& workload);

}  // namespace bench::compare
