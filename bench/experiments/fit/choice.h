// Chooses the candidate that reaches the target at least cost, or says why none does.
#pragma once

#include <string>

#include "bench/contenders/contender.h"
#include "bench/experiments/fit/cost_model.h"
#include "bench/experiments/fit/needed_hits.h"

namespace bench::fit {

/// A candidate with the hits that it needs.
struct Proposal {
    std::size_t candidate = 0;
    double hits = 0;
    std::optional<double> expected;  ///< the error; none where no number of hits reaches the target
    ErrorModel model;
    FitCost cost;
};

/// The outcome for one kind of map.
struct Choice {
    bool reached = false;
    std::string reason;  ///< why not; empty where it was
    Proposal proposal;   ///< the choice; where the target is out of reach, what comes nearest to it
};

/// What is known when the choice is made. All spans are in the candidates' order.
struct Knowledge {
    std::span<const Candidate> candidates;
    const Estimates& estimates;
    std::span<const NeededHits> needed;
    std::span<const std::optional<PilotCost>> costs;
    const ContenderSettings& settings;
    std::size_t max_bytes;  ///< limit on what a method needs while it is built
};

/// Returns the candidates that reach the target at any cost, cheapest first. Candidates of equal bytes are
/// ordered by their hits, then as in `candidates`.
[[nodiscard]] std::vector<Proposal> proposals(const Knowledge& known, const FitGoal& goal, bool light_maps);

[[nodiscard]] Choice choose(const Knowledge& known, const FitGoal& goal, bool light_maps);

/// The largest uncertainty of a sure estimate: z standard errors of a squared error, over the target's
/// square.
inline constexpr double most_doubt = 0.15;

/// Explains why the choice may miss the target more often than one time in ten. Empty where no reason is
/// known or nothing was reached. If estimates are uncertain, the least of many is too low by selection, and a
/// margin on each alone does not correct that. `lost_light` names the light that no path finds.
[[nodiscard]] std::string doubts(const Knowledge& known, const FitGoal& goal, const Choice& choice,
                                 const std::string& lost_light);

}  // namespace bench::fit
