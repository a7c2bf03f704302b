// The hits of a traced run.
#pragma once

#include "common/scene/scene.h"
#include "common/tracer/hit_batch.h"
#include "common/tracer/trace_report.h"

namespace bench {

struct TracedHits {
    common::HitBatch hits;
    common::TraceReport report;
};

/// Returns the hits of the run with this seed, up to `target`.
[[nodiscard]] TracedHits traced(const common::Scene& scene, std::uint64_t seed, common::TraceTarget target);

}  // namespace bench
