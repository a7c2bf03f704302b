// The table of the bases, as JSON and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "bench/experiments/bases/basis_figures.h"
#include "bench/experiments/bases/tilt_curve.h"

namespace bench::bases {

/// Returns an object with context (with the seed), definition, lights, rows and tilt.
[[nodiscard]] nlohmann::ordered_json bases_as_json(std::span<const BasisFigures> figures,
                                                   const TiltCurve& tilt, std::uint64_t seed);

/// Formats the rows in columns.
[[nodiscard]] std::string bases_as_text(std::span<const BasisFigures> figures);

/// Formats the rows in Markdown, with everything that is needed to read them.
[[nodiscard]] std::string bases_as_markdown(std::span<const BasisFigures> figures, std::uint64_t seed);

}  // namespace bench::bases
