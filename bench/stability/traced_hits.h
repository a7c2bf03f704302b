// Hits that the tracer made.
#pragma once

#include "common/tracer/recording_sink.h"
#include "common/tracer/trace_photons.h"

namespace bench {

struct TracedHits {
    common::HitBatch hits;
    common::TraceReport report;
};

/// The hits of the run with this seed, as far as `target` says.
[[nodiscard]] inline TracedHits traced(const common::Scene& scene, std::uint64_t seed,
                                       common::TraceTarget target) {
    const common::RayScene rays(scene);
    const common::PhotonSource source(scene);
    common::RecordingSink sink;
    const common::TraceReport report = common::trace_photons(rays, source, seed, target, sink);
    return {sink.hits(), report};
}

}  // namespace bench
