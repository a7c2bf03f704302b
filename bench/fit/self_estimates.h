// From the pilot's answers to an error model of every candidate, without a reference.
#pragma once

#include <optional>
#include <span>

#include "bench/fit/error_model.h"
#include "bench/fit/pilot.h"

namespace bench::fit {

/// What stands in for the truth. With F a map of so many texels that it blurs little, and not so many that
/// its noise hides what is wanted, and Q the map with a quarter of its texels, all are measured by 2 F - Q:
/// the blur b(h) of a map with texels of side h is taken to be halved with h, so that b(h) = Q - F at every
/// point.
///
/// That is exact for blur in proportion to h. Of an edge that a box of width h blurs, a map with twice F's
/// width gets exactly its squared blur, one with four times the width 9/8 of it; nearest texels and small
/// discs are of that kind. Texels that show their own mean alone have Q - F and F - E orthogonal (one is
/// constant on each of F's texels, the other has the mean zero there): F gets B, which is exact, Q gets 4 B
/// in place of 2 B, and m times the width (m + 2) B in place of m B. Where the light is smooth blur falls
/// with the square of h, and too much is taken off: F gets 9 B. So what is not exact is too large, and the
/// less so the coarser a candidate is than F.
///
/// But for light with detail of all sizes, whose blur hardly falls with h. S with a sixteenth of F's texels
/// tells it: with squared blur in proportion to h^q, (S - Q)^2 is R = 2^q times (Q - F)^2, and F's own is
/// (Q - F)^2 / (R - 1). What that has more than (Q - F)^2 nobody sees who is measured by 2 F - Q: it is added
/// to all.
struct Finest {
    std::size_t candidate = 0;
    std::size_t quarter = 0;               ///< the candidate with a quarter of its texels
    Halves truth;                          ///< 2 F - Q
    SquareEstimate blur_sq;                ///< of F by it: mean w (Q - F)^2
    std::optional<double> coarse_blur_sq;  ///< mean w (S - Q)^2, see above; none without such a map
    SquareEstimate truncation_sq;          ///< of F: by the harmonics beyond the last band
    SquareEstimate unseen_sq;              ///< blur of F that 2 F - Q has as well
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

/// `wanted_error`: relative RMS; candidates that come near it are what is to be measured well; 0 where none
/// counts more than others. `z`: how many standard errors an estimate of bias is to be trusted by. Samples
/// are in the candidates' order. None where the pilot was too small to measure any light map with four times
/// the texels of another.
[[nodiscard]] std::optional<SelfEstimates> estimate_errors(std::span<const Candidate> candidates,
                                                           std::span<const PilotSample> samples,
                                                           const FitPoints& points, double wanted_error,
                                                           double z);

}  // namespace bench::fit
