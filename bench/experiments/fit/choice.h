// Which candidate reaches the target at least cost, and what forbids it where none does.
#pragma once

#include <string>

#include "bench/contenders/contender.h"
#include "bench/experiments/fit/cost_model.h"
#include "bench/experiments/fit/needed_hits.h"

namespace bench::fit {

/// A candidate with the hits that it takes.
struct Proposal {
    std::size_t candidate = 0;
    double hits = 0;
    std::optional<double> expected;  ///< the error; none where no number of hits reaches the target
    ErrorModel model;
    FitCost cost;
};

/// What became of one kind of map.
struct Choice {
    bool reached = false;
    std::string reason;  ///< why not; empty where it was
    Proposal proposal;   ///< the choice; where the target is out of reach, what comes nearest to it
};

/// What is known when one chooses, in the candidates' order.
struct Knowledge {
    std::span<const Candidate> candidates;
    const Estimates& estimates;
    std::span<const NeededHits> needed;
    std::span<const std::optional<PilotCost>> costs;
    const ContenderSettings& settings;
    std::size_t max_bytes;  ///< that a method may need while it is made
};

/// Those that reach the target whatever they cost, the least cost first; equal bytes by their hits, then
/// in the candidates' order.
[[nodiscard]] std::vector<Proposal> proposals(const Knowledge& known, const FitGoal& goal, bool light_maps);

[[nodiscard]] Choice choose(const Knowledge& known, const FitGoal& goal, bool light_maps);

/// What chance may have in an estimate, in squares of the target.
inline constexpr double most_doubt = 0.15;

/// Why the choice may miss the target more often than one time in ten; empty where nothing says so, or
/// nothing was reached. With much doubt the least of many estimates is one that chance has flattered, and no
/// margin for each alone makes up for that. `lost_light`: what no path finds.
[[nodiscard]] std::string doubts(const Knowledge& known, const FitGoal& goal, const Choice& choice,
                                 const std::string& lost_light);

}  // namespace bench::fit
