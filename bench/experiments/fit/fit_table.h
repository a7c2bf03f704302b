// The output of a fit: fit.json, fit.md and a table for the terminal.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/experiments/fit/fit_plan.h"
#include "bench/experiments/fit/search.h"
#include "bench/experiments/fit/verify.h"

namespace bench::fit {

/// Verified runs of both kinds; empty where there was no reference or nothing was reached.
struct FitVerification {
    std::vector<VerifiedRun> light_map, photon_map;
    double reference_error = 0;  ///< of the reference itself, relative RMS; part of every measured error
};

[[nodiscard]] nlohmann::ordered_json fit_as_json(const FitPlan& plan, const FitGoal& goal,
                                                 const common::Scene& scene, const FitResult& result,
                                                 const FitVerification& verified);

/// Returns a row with the error model of every candidate that has one.
[[nodiscard]] nlohmann::ordered_json models_as_json(const FitResult& result);

/// Formats the result for a terminal.
[[nodiscard]] std::string fit_as_text(const nlohmann::ordered_json& document);

/// Formats the same in Markdown, with the cheapest settings of either kind.
[[nodiscard]] std::string fit_as_markdown(const nlohmann::ordered_json& document);

}  // namespace bench::fit
