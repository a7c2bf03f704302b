// A run of a fit's own: shows how far it is, and ends where the user ends it.
#pragma once

#include <string>

#include "bench/app/scene_options.h"
#include "bench/fit/stop.h"
#include "common/core/progress.h"
#include "common/tracer/trace_photons.h"

namespace bench::fit {

/// Throws Interrupted.
template <common::PhotonSink Sink>
common::TraceReport traced_run(const std::string& title, const LoadedScene& scene,
                               const common::PhotonSource& source, std::uint64_t seed,
                               const common::TraceTarget& target, Sink& sink) {
    common::Progress progress(title, "hits", target.hits);
    const auto trace =
        common::trace_photons(scene.rays, source, seed, target, sink, [&](const common::TraceReport& so_far) {
            progress.show(so_far.hits);
            return !common::interrupted();
        });
    stop_if_interrupted();
    return trace;
}

}  // namespace bench::fit
