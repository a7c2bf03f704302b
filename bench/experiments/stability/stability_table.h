// Formats the cases' results as JSON and as text.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {

/// Returns everything that a reader or a chart needs of one case: its texts, the curves with mean, 95 %
/// confidence and band of each point, and whether it has passed.
[[nodiscard]] nlohmann::ordered_json case_as_json(const StabilityCase& stability_case,
                                                  std::span<const StabilityCurve> curves, bool full,
                                                  std::size_t seeds, double seconds);

/// Formats one line per case: its number of judged points, the worst of them, the verdict.
[[nodiscard]] std::string cases_as_text(const nlohmann::ordered_json& rows);

/// Formats the same in Markdown, with all texts, tables and charts. `rows` are in the order of the cases.
[[nodiscard]] std::string cases_as_markdown(const nlohmann::ordered_json& document);

}  // namespace bench::stability
