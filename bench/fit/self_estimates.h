// From the pilot's answers to an error model of every candidate, without a reference.
#pragma once

#include <optional>
#include <span>

#include "bench/fit/error_model.h"
#include "bench/fit/pilot.h"

namespace bench::fit {

/// The candidate that the others are measured by, and what it is itself short of.
///
/// Its blur is what it changes from the map with a quarter of its texels, the mean of (E_T/4 - E_T)^2. That
/// is exact where the light has edges: a texel shows the mean over itself, so E_T/4 - E_T and E_T - E have
/// nothing in common (one is constant on each texel, the other has the mean zero there), squared blurs
/// therefore subtract, and that of an edge is in proportion to the texels' side, of which E_T/4 has twice as
/// much: 2 B - B. Where the light is smooth the blur itself, by a kernel that moves with the point, is halved
/// at least with the side: (2 b - b)^2; with texels that stay where they are it is 4 B - B, too large and
/// safe.
struct Finest {
    std::size_t candidate = 0;
    std::size_t quarter = 0;       ///< the candidate with a quarter of its texels
    SquareEstimate blur_sq;        ///< of the finest map
    SquareEstimate truncation_sq;  ///< by the harmonics beyond the last band
};

/// Models in the candidates' order: none where nothing is known. `best` answers with the least expected
/// error.
struct SelfEstimates {
    Finest finest;
    std::size_t best = 0;
    std::vector<common::Rgb> best_answers;
    std::vector<std::optional<ErrorModel>> model;
    std::vector<bool> measured;  ///< false where the model is a coarser candidate's, carried on
};

/// `z`: how many standard errors an estimate of bias is to be trusted by. Samples are in the candidates'
/// order. None where the pilot was too small to measure any light map with four times the texels of another.
[[nodiscard]] std::optional<SelfEstimates> estimate_errors(std::span<const Candidate> candidates,
                                                           std::span<const PilotSample> samples,
                                                           const FitPoints& points, double z);

}  // namespace bench::fit
