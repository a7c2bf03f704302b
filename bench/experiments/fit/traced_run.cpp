#include "bench/experiments/fit/traced_run.h"

#include "common/core/progress.h"

namespace bench::fit {

common::TraceReport traced_run(const std::string& title, const LoadedScene& scene,
                               const common::PhotonSource& source, std::uint64_t seed,
                               const common::TraceTarget& target, std::span<FilledStore> stores,
                               const StopRule& stop) {
    common::Progress progress(title, "hits", target.hits);
    const common::TraceReport trace =
        trace_into(stores, {scene.rays, source, seed, target, [&](const common::TraceReport& so_far) {
                                progress.show(so_far.hits);
                                return !stop.over();
                            }});
    stop.check();
    return trace;
}

}  // namespace bench::fit
