// Pilots that grow until it is clear what to choose.
#pragma once

#include "bench/experiments/fit/choice.h"
#include "bench/experiments/fit/pilot_archive.h"

namespace bench::fit {

/// Of each half of the first pilot: with less there are not two sizes of texels to compare.
inline constexpr std::uint64_t fewest_pilot_hits = 25'000;

struct SearchLimits {
    std::uint64_t pilot_hits = 0;                              ///< of each half of the last pilot, at most
    double seconds = std::numeric_limits<double>::infinity();  ///< the first pilot is finished all the same
};

/// One kind of map: the choice, and how sure it is.
struct Decision {
    Choice choice;
    std::string doubt;                ///< empty where it is sure (doubts)
    std::vector<Proposal> proposals;  ///< all that reach the target, the least cost first
};

/// All that a fit has found out.
struct FitResult {
    std::vector<Candidate> candidates;
    Estimates estimates;
    std::vector<NeededHits> needed;               ///< in the candidates' order
    std::vector<PilotSample> samples;             ///< in the candidates' order
    std::vector<std::optional<PilotCost>> costs;  ///< in the candidates' order
    Decision light_map, photon_map;
    std::uint64_t pilot_hits = 0;     ///< of each half of the largest pilot that was traced
    std::uint64_t truth_samples = 0;  ///< of each point and half
    std::string lost_light;           ///< what no path finds; then photons stand in for the truth
    double pilot_seconds = 0;         ///< wall time of all that no goal before had asked for
    std::string stopped;              ///< what ended the search before it was done; empty where it was
};

/// Begins with few hits and takes four times as many until both choices are sure and knowing more could save
/// little, or the next pilot would cost more than a twentieth of the two chosen runs (what is out of reach
/// counts as a run of max_hits); at most to the largest. Paths double until their noise is no part of the
/// doubt. Candidates that cannot be chosen any more, or of which enough is known, are not traced again. Where
/// time is the goal and an adaptive map was chosen, smaller pilots of it follow, as long as one is cheaper.
/// Stopped by the user or by its time once the first pilot is there, it answers with what it knows. Throws
/// Interrupted before that, and InputError where the camera sees nothing or it is dark there. The result is
/// the same whatever the archive holds, but for times, which were measured once.
[[nodiscard]] FitResult search(PilotArchive& archive, const FitGoal& goal, const SearchLimits& limits);

}  // namespace bench::fit
