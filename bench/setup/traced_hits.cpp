#include "bench/setup/traced_hits.h"

#include "common/tracer/recording_sink.h"
#include "common/tracer/trace_photons.h"

namespace bench {

TracedHits traced(const common::Scene& scene, std::uint64_t seed, common::TraceTarget target) {
    const common::RayScene rays(scene);
    const common::PhotonSource source(scene);
    common::RecordingSink sink;
    const common::TraceReport report = common::trace_photons(rays, source, seed, target, sink);
    return {sink.hits(), report};
}

}  // namespace bench
