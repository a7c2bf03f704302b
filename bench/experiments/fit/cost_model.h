// Predicts what a candidate costs with so many hits from what its pilot cost.
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

/// Predicts the cost with `hits` hits. Tracing and insertion take their measured time per hit. The bytes,
/// index and gathers of a photon map grow with its hits; those of a light map do not. Times are measured and
/// differ from run to run; bytes do not.
[[nodiscard]] FitCost cost_at(const Candidate& candidate, const PilotCost& pilot, double hits);

/// Returns the costs in the candidates' order. A candidate that was not measured gets those of the next
/// coarser one of its chain. For light maps, bytes and building times are scaled by the ratio of their
/// texels. Tracing takes the same time per hit for all: that of the sample with the most hits. Small pilots
/// take up to twice as long per hit, which would be counted against candidates that needed no larger one.
[[nodiscard]] std::vector<std::optional<PilotCost>> costs_of(std::span<const Candidate> candidates,
                                                             std::span<const PilotSample> samples);

}  // namespace bench::fit
