// From the pilot's answers to an error model of every candidate.
#pragma once

#include <optional>
#include <span>

#include "bench/experiments/fit/error_model.h"
#include "bench/experiments/fit/pilot.h"

namespace bench::fit {

/// Models in the candidates' order: none where nothing is known.
struct Estimates {
    Halves truth;            ///< all bias is measured against it
    double truth_doubt = 0;  ///< standard error that its noise alone leaves in the square of a bias
    std::size_t best = 0;    ///< the candidate with the least expected error
    std::vector<common::Rgb> best_answers;  ///< its mean with the truth: what errors are relative to
    std::vector<std::optional<ErrorModel>> model;
    std::vector<bool> measured;  ///< false where the model is a coarser candidate's, carried on
};

/// Samples are in the candidates' order. `truth`: unbiased, of photons or paths that no sample has seen;
/// where it is not present the photon map of the fewest nearest that was measured stands in for it, which
/// blurs least. `best_so_far`: answers by which errors are relative; empty: those of a photon map of about 64
/// nearest, and then those of the best of all. `z`: how many standard errors an estimate of bias is to be
/// trusted by. None where there is nothing to begin with.
[[nodiscard]] std::optional<Estimates> estimate_errors(std::span<const Candidate> candidates,
                                                       std::span<const PilotSample> samples,
                                                       const Halves& truth, const FitPoints& points,
                                                       std::vector<common::Rgb> best_so_far, double z);

}  // namespace bench::fit
