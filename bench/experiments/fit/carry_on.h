// What is known of a coarse candidate, said of a finer one of its chain.
#pragma once

#include <optional>
#include <span>

#include "bench/experiments/fit/candidates.h"
#include "bench/experiments/fit/error_model.h"

namespace bench::fit {

/// Where noise hides what a fine candidate blurs, a coarser one of its chain says more: squared blur falls at
/// least as the width does. An edge's does just so, and little that light does falls more slowly once a map
/// shows anything of it. Noise rises as one over the square of the width, over patches as much smaller.
/// Truncation stays.
[[nodiscard]] ErrorModel carried_on(const ErrorModel& coarse, double coarse_width, double width);

/// Gives every candidate of a chain, coarse ones first, the smaller of the upper bounds (at z standard
/// errors) of its own bias and of the coarser ones' carried on, unless its own lower bound contradicts these.
/// Shares of the k nearest, whose blur has a limit of its own, have the latter only where they were not
/// measured. `model` has none where nothing was measured.
void carry_on(std::span<const Candidate> candidates, double z, std::span<std::optional<ErrorModel>> model);

}  // namespace bench::fit
