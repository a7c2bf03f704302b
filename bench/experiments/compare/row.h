// One row of the comparison's table.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "bench/experiments/compare/measure_method.h"

namespace bench::compare {

/// All repetitions of one method in one scene with one number of hits.
struct RowInput {
    std::string scene;
    std::string fingerprint;  ///< of the scene, see common/scene/fingerprint.h
    Contender method;
    std::uint64_t hits_asked = 0;
    std::uint64_t seed = 0;
    int threads = 1;
    ContenderSettings settings{};
    std::size_t queries = 0;
    std::size_t texels = 0;                      ///< of the light map; 0 for photon maps
    std::vector<common::TraceReport> null_sink;  ///< one per repetition, paired with `measurements`
    std::vector<Measurement> measurements;
    std::size_t needed_bytes = 0;  ///< as predicted, see bench/contenders/memory_need.h
    std::size_t max_bytes = 0;     ///< --max-memory
    std::string skipped;           ///< why the method was not run, or not completely; empty if it was
};

/// Makes a row of medians over the repetitions; each time has its smallest and largest value beside it.
[[nodiscard]] nlohmann::ordered_json make_row(const RowInput& input);

/// Formats a table with one line per row. Its columns are the union of the rows' scalar ones; lists are left
/// out.
[[nodiscard]] std::string rows_as_csv(const nlohmann::ordered_json& rows);

/// Formats the most important columns for the terminal.
[[nodiscard]] std::string rows_as_text(const nlohmann::ordered_json& rows);

}  // namespace bench::compare
