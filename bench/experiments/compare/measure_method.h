// Times one run of one method: trace, insert, build, gather.
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

/// The cost of a run. Times are wall seconds.
struct Measurement {
    Preparation preparation;         ///< of the scene, made before the first run
    double making_room_seconds = 0;  ///< for an empty store: a light map allocates its sums at once
    common::TraceReport trace;
    double build_seconds = 0;
    double gather_seconds = 0;  ///< all query points in image order, one thread
    double gather_shuffled_seconds = 0;
    std::size_t bytes = 0;                  ///< finished map with its index
    std::size_t insert_bytes = 0;           ///< the store while it took hits
    std::size_t resident_before_bytes = 0;  ///< of the process: scene, texels and the program itself
    std::size_t peak_resident_bytes = 0;    ///< of the process, while this method ran
    bool peak_is_of_this_run = true;  ///< false if the system cannot reset it: it is then since the start
    common::RejectedHits rejected;
    std::string given_up;        ///< why the run was ended early and its memory freed; empty if it was not
    double mean_irradiance = 0;  ///< over query points and channels, W/m^2, to compare the methods' answers
};

/// The input of a run.
struct Workload {
    const LoadedScene& scene;
    const common::PhotonSource& source;
    const QueryPoints& queries;
    std::uint64_t seed;
    common::TraceTarget target;
    common::TraceProgress progress;
    std::size_t max_bytes =
        std::numeric_limits<std::size_t>::max();  ///< limit on what the method adds to the process
    common::RecordedHits recorded = common::RecordedHits::all;
};

/// Measures one run, using the threads of the calling arena for all but the gathers. An interrupted run has
/// trace.interrupted set and nothing measured after the trace. The same holds for a run that exceeds
/// max_bytes or runs out of memory, which is checked after each wave of hits and after the build.
[[nodiscard]] Measurement measure_method(const Contender& contender, PreparedScene& scene,
                                         const Workload& workload);

/// Runs the same trace without a store.
[[nodiscard]] common::TraceReport measure_null_sink(const Workload& workload);

}  // namespace bench::compare
