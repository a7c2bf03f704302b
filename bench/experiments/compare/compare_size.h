// One scene at one number of hits: every method in turn, again and again.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/experiments/compare/compare_plan.h"
#include "bench/experiments/compare/row.h"

namespace bench::compare {

/// A scene with all that a comparison needs of it.
struct CompareScene {
    const LoadedScene& loaded;
    const common::PhotonSource& source;
    const QueryPoints& queries;
    PreparedScene& prepared;
    std::string fingerprint;  ///< see common/scene/fingerprint.h
};

struct SizeResult {
    std::vector<nlohmann::ordered_json> rows;  ///< one per method, measured or skipped
    bool interrupted = false;  ///< the user ended it: rows have whole repetitions only, maybe none
};

/// Runs the methods interleaved, each repetition beginning with another one, next to the null sink.
[[nodiscard]] SizeResult compare_size(const ComparePlan& plan, const CompareScene& scene,
                                      const std::vector<Contender>& methods, std::uint64_t hits);

}  // namespace bench::compare
