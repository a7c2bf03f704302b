// The exposures at which HDR-FLIP shows two images (Andersson et al., "Visualizing Errors in Rendered High
// Dynamic Range Images", 2021).
#pragma once

#include <span>
#include <vector>

#include "common/core/vector.h"

namespace common {

/// Evenly spaced stops: an image is shown multiplied by 2^stop.
struct Exposures {
    double start = 0;  ///< shows the reference's brightest pixel at 0.85 of the display's white
    double stop = 0;   ///< shows its median at 0.85; of two middle pixels, the brighter counts
    int count = 2;     ///< number of exposures: one per stop, at least 2

    [[nodiscard]] double at(int i) const { return start + i * (stop - start) / (count - 1); }
};

/// Finds the exposures from the luminance (Rec. 709) of the reference's pixels, at least one; negative values
/// count as 0. A median below 2^-23 counts as 2^-23, as in the published evaluator. Throws InputError if all
/// pixels are black.
[[nodiscard]] Exposures exposures_for(std::span<const Rgb> reference);

/// Returns the image at an exposure, tone-mapped: linear RGB, 0 to 1. The curve is Narkowicz's fit to the
/// ACES filmic curve (2015), applied to 0.6 of the light, the published evaluator's default.
[[nodiscard]] std::vector<Rgb> displayed(std::span<const Rgb> image, double exposure);

}  // namespace common
