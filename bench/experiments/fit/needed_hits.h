// How many hits a candidate takes to reach the target.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bench/experiments/fit/estimates.h"

namespace bench::fit {

/// What is wanted, and what may be spent on it.
struct FitGoal {
    double target = 0;  ///< relative RMS error, the root of relMSE
    double z = 0;       ///< a run meets the target with the probability of a normal variable to be below z
    double margin = 1;  ///< so many times what z asks for: squared errors are no normal variables
    /// The same for what is tried with one number of hits after another and taken as soon as it passes: each
    /// try is another chance to be flattered.
    double z_of_tries = 0;
    bool least_bytes = false;  ///< bytes are to be few, else seconds
    double budget_bytes = std::numeric_limits<double>::infinity();
    double budget_seconds = std::numeric_limits<double>::infinity();
    double max_hits = 0;

    [[nodiscard]] const char* least() const { return least_bytes ? "bytes" : "time"; }
};

/// Standard errors that an estimate by this model is trusted by.
[[nodiscard]] double z_of(const FitGoal& goal, const ErrorModel& model);

/// What is added to the squared error of a run with so many hits, so that it is bounded.
[[nodiscard]] inline double margin_of(const FitGoal& goal, const ErrorModel& model, double hits) {
    return goal.margin * z_of(goal, model) * model.deviation(hits);
}

struct NeededHits {
    std::optional<double>
        sure;  ///< that allow for chance: none where no number of hits does, or nothing is known
    std::optional<double> likely;      ///< if the estimates were exact
    std::optional<double> least;       ///< at the very best: no bias beyond what is certain, no bad luck
    std::optional<double> expected{};  ///< the error with the hits that are sure
    /// The error, allowing for chance, of infinitely many hits; infinite where nothing is known.
    double without_noise = std::numeric_limits<double>::infinity();
};

/// In the candidates' order.
[[nodiscard]] std::vector<NeededHits> needed_by_error(const Estimates& estimates, const FitGoal& goal);

}  // namespace bench::fit
