// FLIP: the difference, per pixel from 0 to 1, that a viewer sees when flipping between two images.
#pragma once

#include <span>
#include <vector>

#include "common/difference/flip_exposures.h"

namespace common {

/// Pixels per degree of visual angle, at 0.7 m from a display of 3840 pixels that is 0.7 m wide: the
/// published default.
inline constexpr float flip_pixels_per_degree = 67.02064f;

/// Returns the map of LDR-FLIP (Andersson, Nilsson, Akenine-Moeller et al., "FLIP: A Difference Evaluator for
/// Alternating Images", 2020) of two images as a display shows them: linear RGB, 0 to 1, `width` times
/// `height` pixels row by row. It is symmetric in the two images. Throws InputError unless both have width *
/// height pixels, all finite.
[[nodiscard]] std::vector<float> displayed_flip_map(std::span<const Rgb> image,
                                                    std::span<const Rgb> reference, int width, int height);

/// Returns the map of HDR-FLIP (Andersson, Nilsson, Shirley and Akenine-Moeller, "Visualizing Errors in
/// Rendered High Dynamic Range Images", 2021). It is the largest LDR-FLIP over the exposures that show the
/// reference from its brightest pixel to its median (flip_exposures.h). Pixels are linear RGB in any unit,
/// finite; negative values count as 0. Values agree to 1e-4 with the published evaluator, flip_evaluator 1.7;
/// tests/difference/flip_test.cpp has them.
///
/// Throws InputError unless both have width * height pixels, all finite, and the reference is not black.
[[nodiscard]] std::vector<float> flip_map(std::span<const Rgb> image, std::span<const Rgb> reference,
                                          int width, int height);

/// Returns the same at given exposures, such as those of a part of the reference: pixels that are not
/// compared must not choose the exposures.
[[nodiscard]] std::vector<float> flip_map(std::span<const Rgb> image, std::span<const Rgb> reference,
                                          int width, int height, const Exposures& exposures);

/// Returns the mean over pixels, which is the FLIP value of an image.
[[nodiscard]] double flip_mean(std::span<const float> map);

}  // namespace common
