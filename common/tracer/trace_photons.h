// Photon tracing: traces blocks of photons in parallel and passes their hits to a sink.
#pragma once

#include <functional>

#include "common/tracer/trace_block.h"
#include "common/tracer/trace_report.h"
#include "common/tracer/wave.h"

namespace common {

/// Called between waves with the report so far; returns false to end the run there.
using TraceProgress = std::function<bool(const TraceReport& so_far)>;

/// Traces the photons from target.first_photon on of the run with this seed and passes their hits to `sink`.
/// `so_far` is the report of an earlier call, which this call continues to the same end. Between two waves
/// the sink has taken the hits of the photons so far, and no others.
///
/// With RecordedHits::indirect, direct hits are neither passed on nor counted; photons' paths are the same.
///
/// The hits that the sink gets, and the report's counts, depend only on the scene, the seed and the target.
/// If the sink is not unordered, so does their order. Uses the threads of the calling arena (see ThreadPool).
template <PhotonSink Sink>
TraceReport trace_photons(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                          TraceTarget target, Sink& sink, const TraceProgress& progress = {},
                          const TraceReport& so_far = {}, RecordedHits recorded = RecordedHits::all) {
    OrderedWaves ordered(rays, source, seed, recorded);
    UnorderedWaves unordered(rays, source, seed, recorded);
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

/// Returns the finished, immutable map of a sink that has taken a whole run.
template <MapSink Sink>
[[nodiscard]] auto finish_map(Sink&& sink, const TraceReport& report) {
    return std::move(sink).finish(report.watts_per_flux());
}

}  // namespace common
