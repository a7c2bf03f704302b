// One scene, number of hits and seed: one trace feeds the stores of all methods, and each is asked.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/contenders/reference_scene.h"
#include "bench/experiments/study/study_plan.h"

namespace bench::study {

struct StudyRun {
    std::vector<nlohmann::ordered_json> rows;  ///< one per method, measured or skipped
    bool interrupted = false;                  ///< the user ended it; there are no rows then
};

/// `methods` in the plan's order. Writes each method's answers.
[[nodiscard]] StudyRun run_study(const StudyPlan& plan, ReferenceScene& scene,
                                 const std::vector<Contender>& methods, std::uint64_t hits,
                                 std::uint64_t seed);

}  // namespace bench::study
