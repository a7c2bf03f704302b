// Finds how many hits a candidate needs to reach the target.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bench/experiments/fit/estimates.h"

namespace bench::fit {

/// The target and the limits on its cost.
struct FitGoal {
    double target = 0;  ///< relative RMS error, the root of relMSE
    double z = 0;  ///< a run meets the target with the probability that a standard normal variable is below z
    double margin = 1;  ///< a factor on z, as squared errors are not normally distributed
    /// The z of candidates that are tried with one number of hits after another until one passes. Each try is
    /// another chance to pass by luck.
    double z_of_tries = 0;
    bool least_bytes = false;  ///< the goal is few bytes; otherwise it is little time
    double budget_bytes = std::numeric_limits<double>::infinity();
    double budget_seconds = std::numeric_limits<double>::infinity();
    double max_hits = 0;

    [[nodiscard]] const char* least() const { return least_bytes ? "bytes" : "time"; }
};

/// Returns how many standard errors bound an estimate by this model.
[[nodiscard]] double z_of(const FitGoal& goal, const ErrorModel& model);

/// Returns the margin that makes error_sq an upper bound for a run with so many hits.
[[nodiscard]] inline double margin_of(const FitGoal& goal, const ErrorModel& model, double hits) {
    return goal.margin * z_of(goal, model) * model.deviation(hits);
}

struct NeededHits {
    std::optional<double>
        sure;  ///< with the margin for chance: none where no number of hits suffices, or nothing is known
    std::optional<double> likely;  ///< if the estimates were exact
    std::optional<double> least;   ///< in the best case: only bias that is certain, and no margin for chance
    std::optional<double> expected{};  ///< the expected error with `sure` hits
    /// Upper bound of the error with infinitely many hits; infinite where nothing is known.
    double without_noise = std::numeric_limits<double>::infinity();
};

/// Returns the needed hits of all candidates, in their order.
[[nodiscard]] std::vector<NeededHits> needed_by_error(const Estimates& estimates, const FitGoal& goal);

}  // namespace bench::fit
