// The output of --explain: a table in fit.json, in fit.md and on the terminal, and explanation.json for the
// picture.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/experiments/fit/explanation.h"

namespace bench::fit {

/// Returns one row per visible mesh instance, the most error first.
[[nodiscard]] nlohmann::ordered_json explanation_as_json(const Explanation& explanation,
                                                         const common::Scene& scene);

/// Returns all pixels in the form that bench/report/fit/explanation_chart.py reads.
[[nodiscard]] nlohmann::ordered_json picture_as_json(const Explanation& explanation,
                                                     const nlohmann::ordered_json& fit);

/// Formats at most `rows` rows in Markdown, which also reads well on a terminal.
[[nodiscard]] std::string explanation_text(const nlohmann::ordered_json& surfaces, std::size_t rows);

}  // namespace bench::fit
