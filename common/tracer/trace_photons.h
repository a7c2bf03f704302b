// Photon tracing: blocks of photons in parallel, their hits to a sink.
#pragma once

#include <functional>

#include "common/tracer/trace_block.h"
#include "common/tracer/trace_report.h"
#include "common/tracer/wave.h"

namespace common {

/// Called between waves with what is done so far; returns false to end the run there.
using TraceProgress = std::function<bool(const TraceReport& so_far)>;

/// Traces the photons target.first_photon and on of the run with this seed and gives their hits to `sink`.
/// `so_far` is what an earlier call has done of them: this one goes on from there to the same end. Between
/// two waves the sink has taken the hits of the photons so far, and no others.
///
/// Which hits the sink gets, and the report's counts, depend on the scene, the seed and the target alone; a
/// sink that is not unordered gets them in an order that depends on these alone too. Uses the threads of the
/// calling arena (see ThreadPool).
template <PhotonSink Sink>
TraceReport trace_photons(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                          TraceTarget target, Sink& sink, const TraceProgress& progress = {},
                          const TraceReport& so_far = {}) {
    OrderedWaves ordered(rays, source, seed);
    UnorderedWaves unordered(rays, source, seed);
    TraceReport report = so_far;
    report.interrupted = false;
    while (!target.reached_by(report)) {
        const std::size_t whole_blocks = UnorderedSink<Sink> ? whole_blocks_ahead(report, target) : 0;
        if constexpr (UnorderedSink<Sink>)
            if (whole_blocks > 0) unordered.trace(whole_blocks, target, sink, report);
        if (whole_blocks == 0) ordered.trace(target, sink, report);

        check_that_photons_hit(report, target);
        if (progress && !progress(report)) {
            report.interrupted = true;
            break;
        }
    }
    return report;
}

/// The finished, immutable map of a sink that has taken a whole run.
template <MapSink Sink>
[[nodiscard]] auto finish_map(Sink&& sink, const TraceReport& report) {
    return std::move(sink).finish(report.watts_per_flux());
}

}  // namespace common
