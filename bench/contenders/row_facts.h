// Describes the contender in a row of results.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/contenders/contender.h"

namespace bench {

/// Adds "method", the name; "fields", its parsed parts, so that no reader has to parse it; and "style", how
/// it is drawn: {"colour": "#rrggbb", "marker": "o"}.
inline void add_facts(nlohmann::ordered_json& row, const Contender& contender) {
    const ChartStyle style = contender->style();
    row["method"] = contender.name;
    row["fields"] = contender->fields();
    row["style"] = {{"colour", style.colour}, {"marker", style.marker}};
}

}  // namespace bench
