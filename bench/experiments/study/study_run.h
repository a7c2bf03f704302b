// Runs one scene, number of hits and seed: one trace fills the stores of all methods that fit into memory
// together, which are then evaluated.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/contenders/reference_scene.h"
#include "bench/experiments/study/study_plan.h"

namespace bench::study {

struct StudyRun {
    std::vector<nlohmann::ordered_json> rows;  ///< one per method, measured or skipped
    bool interrupted = false;                  ///< by the user; there are rows of what was measured alone
};

/// Runs `methods`, which are in the plan's order, and writes each one's answers.
[[nodiscard]] StudyRun run_study(const StudyPlan& plan, ReferenceScene& scene,
                                 const std::vector<Contender>& methods, std::uint64_t hits,
                                 std::uint64_t seed);

}  // namespace bench::study
