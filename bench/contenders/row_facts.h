// What a row of results says of its contender.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/contenders/contender.h"

namespace bench {

/// Adds "method", the name; "fields", what it says, so that nobody has to read it again; and "style", how it
/// is drawn: {"colour": "#rrggbb", "marker": "o"}.
inline void add_facts(nlohmann::ordered_json& row, const Contender& contender) {
    const ChartStyle style = contender->style();
    row["method"] = contender.name;
    row["fields"] = contender->fields();
    row["style"] = {{"colour", style.colour}, {"marker", style.marker}};
}

}  // namespace bench
