#include "bench/experiments/fit/traced_run.h"

#include "bench/experiments/fit/stop.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"

namespace bench::fit {

common::TraceReport traced_run(const std::string& title, const LoadedScene& scene,
                               const common::PhotonSource& source, std::uint64_t seed,
                               const common::TraceTarget& target, std::span<FilledStore> stores) {
    common::Progress progress(title, "hits", target.hits);
    const common::TraceReport trace =
        trace_into(stores, {scene.rays, source, seed, target, [&](const common::TraceReport& so_far) {
                                progress.show(so_far.hits);
                                return !common::interrupted();
                            }});
    stop_if_interrupted();
    return trace;
}

}  // namespace bench::fit
