// Compares all methods in one scene with one number of hits, in interleaved repetitions.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/experiments/compare/compare_plan.h"
#include "bench/experiments/compare/row.h"

namespace bench::compare {

/// A scene with everything that a comparison needs of it.
struct CompareScene {
    const LoadedScene& loaded;
    const common::PhotonSource& source;
    const QueryPoints& queries;
    PreparedScene& prepared;
    std::string fingerprint;  ///< see common/scene/fingerprint.h
};

struct SizeResult {
    std::vector<nlohmann::ordered_json> rows;  ///< one per method, measured or skipped
    bool interrupted = false;  ///< by the user: rows then have whole repetitions only, possibly none
};

/// Runs the methods and the null sink interleaved. Each repetition begins with another method.
[[nodiscard]] SizeResult compare_size(const ComparePlan& plan, const CompareScene& scene,
                                      const std::vector<Contender>& methods, std::uint64_t hits);

}  // namespace bench::compare
