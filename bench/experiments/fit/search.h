// Runs ever larger pilots until the choice is clear.
#pragma once

#include "bench/experiments/fit/choice.h"
#include "bench/experiments/fit/pilot_archive.h"

namespace bench::fit {

/// Hits of each half of the first pilot, at least. With fewer there are not two sizes of texels to compare.
inline constexpr std::uint64_t fewest_pilot_hits = 25'000;

struct SearchLimits {
    std::uint64_t pilot_hits = 0;                              ///< of each half of the last pilot, at most
    double seconds = std::numeric_limits<double>::infinity();  ///< the first pilot is always finished
};

/// The choice of one kind of map, and how certain it is.
struct Decision {
    Choice choice;
    std::string doubt;                ///< the reason why it is not sure (doubts); empty where it is
    std::vector<Proposal> proposals;  ///< all that reach the target, the least cost first
};

/// Everything that a fit has found.
struct FitResult {
    std::vector<Candidate> candidates;
    Estimates estimates;
    std::vector<NeededHits> needed;               ///< in the candidates' order
    std::vector<PilotSample> samples;             ///< in the candidates' order
    std::vector<std::optional<PilotCost>> costs;  ///< in the candidates' order
    Decision light_map, photon_map;
    std::uint64_t pilot_hits = 0;     ///< of each half of the largest pilot that was traced
    std::uint64_t truth_samples = 0;  ///< per point and half
    std::string lost_light;           ///< light that no path finds; if any, photons replace the truth
    double pilot_seconds = 0;         ///< wall time, without what an earlier goal had already traced
    std::string stopped;              ///< what ended the search before it was done; empty where it was
};

/// Grows the pilot from few hits, fourfold each time. It ends when both choices are sure and more knowledge
/// could save little, or when the next pilot would cost more than a twentieth of the two chosen runs. A
/// target out of reach counts as a run of max_hits. The pilot never exceeds its largest size. Path samples
/// double until their noise has no part in the doubt. Candidates that cannot be chosen any more, or are known
/// well enough, are not traced again. If time is the goal and an adaptive map was chosen, smaller pilots of
/// it follow as long as one is cheaper.
/// If the user or the time limit stops it after the first pilot, it returns what is known. Throws Interrupted
/// before that, and InputError where the camera sees nothing or only darkness. The result does not depend on
/// what the archive holds, except for times, which are measured once.
[[nodiscard]] FitResult search(PilotArchive& archive, const FitGoal& goal, const SearchLimits& limits);

}  // namespace bench::fit
