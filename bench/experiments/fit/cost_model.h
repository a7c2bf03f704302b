// What a candidate costs at so many hits, from what its pilot has cost.
#pragma once

#include <optional>
#include <span>

#include "bench/experiments/fit/pilot.h"

namespace bench::fit {

struct FitCost {
    double seconds = 0;  ///< trace, insertion, index and the answers at all points: wall time of all threads
    double bytes = 0;    ///< of the finished map with its index
    double prepare_seconds = 0;  ///< once for the scene, not in `seconds`
};

/// Tracing and insertion take their measured time for each hit. A photon map's bytes, index and gathers grow
/// as its hits do; a light map's do not. Times are measured and differ from run to run; bytes do not.
[[nodiscard]] FitCost cost_at(const Candidate& candidate, const PilotCost& pilot, double hits);

/// Costs in the candidates' order. Of one that was not measured: those of the next coarser one of its chain,
/// a light map's with as many more bytes and seconds of building as it has more texels.
[[nodiscard]] std::vector<std::optional<PilotCost>> costs_of(std::span<const Candidate> candidates,
                                                             std::span<const PilotSample> samples);

}  // namespace bench::fit
