// Pilots that grow until it is clear what to choose.
#pragma once

#include "bench/experiments/fit/choice.h"
#include "bench/experiments/fit/pilot_archive.h"

namespace bench::fit {

/// Of each half of the first pilot: with less there are not two sizes of texels to compare.
inline constexpr std::uint64_t fewest_pilot_hits = 25'000;

struct SearchLimits {
    std::uint64_t pilot_hits = 0;  ///< of each half of the last pilot, at most
};

/// All that a fit has found out.
struct FitResult {
    std::vector<Candidate> candidates;
    Estimates estimates;
    std::vector<NeededHits> needed;               ///< in the candidates' order
    std::vector<PilotSample> samples;             ///< in the candidates' order
    std::vector<std::optional<PilotCost>> costs;  ///< in the candidates' order
    Choice light_map, photon_map;
    std::vector<Proposal> light_maps, photon_maps;  ///< all that reach the target, the least cost first
    std::uint64_t pilot_hits = 0;                   ///< of each half of the largest pilot that was traced
    double pilot_seconds = 0;  ///< wall time of all pilots that no goal before had asked for
};

/// Begins with 1/1024 of the largest pilot, or the least share by powers of four that has
/// fewest_pilot_hits, and takes four times as much until the finest map blurs little itself, the choices
/// owe little to chance and either knowing more could hardly save anything or the next pilot would have
/// more hits than 16 of the two chosen runs; at most to the largest. What is out of reach counts as a run
/// of max_hits. Candidates that cannot be chosen any more, or of which enough is known, are not traced
/// again. Where time is the goal and blocks change with the hits, smaller pilots follow, as long as one of
/// them makes the light map cheaper. Throws Interrupted, and InputError where the camera sees nothing or it
/// is dark there. The result is the same whatever the archive holds, but for times, which were measured
/// once.
[[nodiscard]] FitResult search(const PilotSubject& subject, const FitGoal& goal, const SearchLimits& limits,
                               PilotArchive& archive);

}  // namespace bench::fit
