// From the pilot's answers to an error model of every candidate, without a reference.
#pragma once

#include <optional>
#include <span>

#include "bench/experiments/fit/error_model.h"
#include "bench/experiments/fit/pilot.h"

namespace bench::fit {

/// What stands in for the truth E: F, a map of so many texels that it blurs little, and not so many that its
/// noise hides what is wanted, less half of what Q blurs more, the map with a quarter of F's texels:
/// T = F - (Q - F) / 2. What F blurs is taken to be 3/2 D, D = (Q - F)^2. (F - T)^2 has D / 4 of it, what is
/// missing is added to all that is measured by T.
///
/// All this is halfway between two cases, of which light has something each. Texels that show their own mean
/// alone, one in another, are constant on each of F's texels, where F - E has the mean zero: F blurs D, and
/// of others F itself tells all but that. Maps that blur an edge just as F does, only wider, are told exactly
/// by 2 F - Q, and F blurs 2 D. Maps with 1, 2, 4 and 8 times F's width blur 1, 2, 4 and 8 D in the first
/// case and get 1.5, 3.5, 5.5 and 9.5 D; they blur 2, 4, 8 and 16 D in the second and get 1.5, 3.5, 7.8
/// and 15.9 D.
///
/// But for light with detail of all sizes, whose blur hardly falls with the side h of a texel. S with a
/// sixteenth of F's texels tells it: with squared blur in proportion to h^q, (S - Q)^2 is R = 2^q times
/// D, and F's own is D / (R - 1) where that is more.
struct Finest {
    std::size_t candidate = 0;
    Halves truth;                  ///< T
    SquareEstimate blur_sq;        ///< of F: mean w (F - E)^2, by the size of its texels
    SquareEstimate unseen_sq;      ///< what of it is not in (F - T)^2
    SquareEstimate truncation_sq;  ///< of F: by the harmonics beyond the last band
    double expected_blur_sq = 0;   ///< of F by (S - Q)^2: its own would favour the map that chance flatters
};

/// Models in the candidates' order: none where nothing is known. `best` answers with the least expected
/// error.
struct Estimates {
    Finest finest;
    std::size_t best = 0;
    std::vector<common::Rgb> best_answers;
    std::vector<std::optional<ErrorModel>> model;
    std::vector<bool> measured;  ///< false where the model is a coarser candidate's, carried on
};

/// `wanted_error`: relative RMS; candidates that come near it are what is to be measured well; 0 where none
/// counts more than others. `z`: how many standard errors an estimate of bias is to be trusted by. Samples
/// are in the candidates' order. None where the pilot was too small to measure any light map with four times
/// the texels of another.
[[nodiscard]] std::optional<Estimates> estimate_errors(std::span<const Candidate> candidates,
                                                       std::span<const PilotSample> samples,
                                                       const FitPoints& points, double wanted_error,
                                                       double z);

}  // namespace bench::fit
