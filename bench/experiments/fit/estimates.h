// Makes an error model of every candidate from the answers of the pilot.
#pragma once

#include <optional>
#include <span>

#include "bench/experiments/fit/error_model.h"
#include "bench/experiments/fit/pilot.h"

namespace bench::fit {

/// Error models in the candidates' order; none where nothing is known.
struct Estimates {
    Halves truth;            ///< the estimate against which all bias is measured
    double truth_doubt = 0;  ///< standard error of a squared bias that is due to the noise of `truth` alone
    std::size_t best = 0;    ///< the candidate with the least bias^2 + noise^2 / 2 plus one standard error
    std::vector<common::Rgb> best_answers;  ///< its answers combined with the truth: denominators of errors
    std::vector<std::optional<ErrorModel>> model;
    std::vector<bool> measured;  ///< false where the model is extrapolated from a coarser candidate
};

/// Estimates the error model of every candidate; samples are in the candidates' order. `truth` is unbiased
/// and made of photons or paths that are in no sample. Where it is not present, the measured photon map with
/// the fewest nearest photons, which blurs least, replaces it. Errors are relative to `best_so_far`. If that
/// is empty, they are relative first to a photon map of about 64 nearest, then to the best of all. Biases are
/// bounded at `z` standard errors. Returns none where there is no photon map to begin with.
[[nodiscard]] std::optional<Estimates> estimate_errors(std::span<const Candidate> candidates,
                                                       std::span<const PilotSample> samples,
                                                       const Halves& truth, const FitPoints& points,
                                                       std::vector<common::Rgb> best_so_far, double z);

}  // namespace bench::fit
