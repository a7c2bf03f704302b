// Hits that the tracer made.
#pragma once

#include "common/scene/scene.h"
#include "common/tracer/hit_batch.h"
#include "common/tracer/trace_report.h"

namespace bench {

struct TracedHits {
    common::HitBatch hits;
    common::TraceReport report;
};

/// The hits of the run with this seed, as far as `target` says.
[[nodiscard]] TracedHits traced(const common::Scene& scene, std::uint64_t seed, common::TraceTarget target);

}  // namespace bench
