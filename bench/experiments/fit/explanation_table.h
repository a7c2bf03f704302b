// What --explain says: a table in fit.json, fit.md and on the terminal, and the picture's explanation.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/experiments/fit/explanation.h"

namespace bench::fit {

/// One row per mesh instance that is seen, the most error first.
[[nodiscard]] nlohmann::ordered_json explanation_as_json(const Explanation& explanation,
                                                         const common::Scene& scene);

/// All pixels, as bench/report/fit/explanation_chart.py reads them.
[[nodiscard]] nlohmann::ordered_json picture_as_json(const Explanation& explanation,
                                                     const nlohmann::ordered_json& fit);

/// In Markdown, which reads well on a terminal too. `rows` at most.
[[nodiscard]] std::string explanation_text(const nlohmann::ordered_json& surfaces, std::size_t rows);

}  // namespace bench::fit
