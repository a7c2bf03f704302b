// Extrapolates the error of a coarse candidate to a finer one of its chain.
#pragma once

#include <optional>
#include <span>

#include "bench/experiments/fit/candidates.h"
#include "bench/experiments/fit/error_model.h"

namespace bench::fit {

/// Extrapolates the error model of a coarse candidate to a finer one of its chain, where noise may hide the
/// blur. The law is that squared blur falls in proportion to the width. This is exact for an edge, and little
/// else in a light field falls more slowly once a map resolves any of it. The variance of the noise grows as
/// 1 / width^2, and its correlated patches shrink by the same factor. Truncation stays as it is.
[[nodiscard]] ErrorModel carried_on(const ErrorModel& coarse, double coarse_width, double width);

/// Tightens the bias of each candidate by the coarser ones of its chain, which come first. A candidate gets
/// the smaller of two upper bounds at z standard errors: its own and the extrapolated one. It keeps its own
/// where its lower bound contradicts the extrapolation. Shares of the k nearest, whose blur has a limit of
/// its own, are extrapolated only where they were not measured. `model` holds none where nothing was
/// measured.
void carry_on(std::span<const Candidate> candidates, double z, std::span<std::optional<ErrorModel>> model);

}  // namespace bench::fit
