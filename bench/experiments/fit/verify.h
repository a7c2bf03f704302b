// Measures what a chosen setting really achieves: traced again with other seeds, against a reference.
#pragma once

#include <vector>

#include "bench/contenders/reference_scene.h"
#include "bench/experiments/fit/candidates.h"

namespace bench::fit {

/// One run. Times are wall time of all threads.
struct VerifiedRun {
    std::uint64_t seed = 0;
    std::uint64_t hits = 0;
    double error = 0;        ///< relative RMS, the reference's own error included
    double worst_share = 0;  ///< fraction of the squared error in the worst thousandth of the points
    double seconds = 0;      ///< trace, insertion, index and all answers
    std::size_t bytes = 0;
};

/// Runs the candidate with the seeds after the pilot's. Returns fewer runs if the user interrupts it.
[[nodiscard]] std::vector<VerifiedRun> verify(const Candidate& candidate, std::uint64_t hits,
                                              std::uint64_t pilot_seed, std::size_t seeds,
                                              ReferenceScene& scene);

}  // namespace bench::fit
