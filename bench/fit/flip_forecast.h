// FLIP of a candidate's picture at any number of hits, before that many are traced.
#pragma once

#include "bench/fit/fit_points.h"
#include "bench/fit/needed_hits.h"
#include "bench/fit/pilot.h"
#include "common/difference/flip_exposures.h"

namespace bench::fit {

/// FLIP is no mean of squares: it does not split into noise, blur and truncation. So pictures are made as a
/// run would show them, and FLIP is taken of those. With n hits in each half a and b of the pilot, and `best`
/// the answers of least expected error, a run of N hits is taken to show
///
///     best + bias + sqrt(n / N) (a - b) / sqrt(2)
///
/// The last term is one draw of the noise. The bias is (a + b) / 2 - best, much of which may be noise of
/// both, and FLIP sees noise less than it does the same light in one place. So it is averaged over as many
/// pixels as leave a quarter of its square to noise, 9 x 9 at most, and then scaled to have the mean square
/// that the error model knows, weighted as there.
class FlipForecast {
  public:
    /// Throws InputError where `best` is black.
    FlipForecast(const FitPoints& points, const SelfEstimates& estimates);

    /// Of a candidate with these halves; its bias has this mean square, relative as in ErrorModel. `hits` may
    /// be infinite.
    [[nodiscard]] double flip(const PilotSample& sample, double bias_sq, double hits) const {
        return flip(sample, shown_bias(sample, bias_sq), hits);
    }

    /// The same by what does not depend on the hits: the bias of each point, W/m^2.
    [[nodiscard]] std::vector<common::Rgb> shown_bias(const PilotSample& sample, double bias_sq) const;
    [[nodiscard]] double flip(const PilotSample& sample, std::span<const common::Rgb> shown_bias,
                              double hits) const;

  private:
    /// Over the pixels around each point, up to `reach` away, of those that have one.
    [[nodiscard]] std::vector<common::Rgb> averaged(std::span<const common::Rgb> values, int reach) const;
    [[nodiscard]] std::vector<common::Rgb> picture_of(std::span<const common::Rgb> answers) const;

    const FitPoints& points_;
    const SelfEstimates& estimates_;
    Measure measure_;
    std::vector<float> present_;          ///< of each pixel: 1 where it has a point, else 0
    std::vector<common::Rgb> reference_;  ///< all pixels
    common::Exposures exposures_;
};

/// By FLIP, in the candidates' order: nothing is known of those that were not measured, or whose halves are
/// noise for the most part.
[[nodiscard]] std::vector<NeededHits> needed_by_flip(const SelfEstimates& estimates,
                                                     std::span<const PilotSample> samples,
                                                     const FitPoints& points, const FitGoal& goal);

}  // namespace bench::fit
