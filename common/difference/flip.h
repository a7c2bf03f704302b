// FLIP: how large a difference a viewer sees who flips between two images, per pixel from 0 to 1.
#pragma once

#include <span>
#include <vector>

#include "common/difference/flip_exposures.h"

namespace common {

/// Where the viewer is: at 0.7 m from a display of 3840 pixels that is 0.7 m wide, the published default.
inline constexpr float flip_pixels_per_degree = 67.02064f;

/// LDR-FLIP (Andersson, Nilsson, Akenine-Moeller et al., "FLIP: A Difference Evaluator for Alternating
/// Images", 2020) of two images as a display shows them: linear RGB, 0 to 1, `width` times `height` pixels
/// row by row. The two may be exchanged. Throws InputError unless both have width * height pixels, all
/// finite.
[[nodiscard]] std::vector<float> displayed_flip_map(std::span<const Rgb> image,
                                                    std::span<const Rgb> reference, int width, int height);

/// HDR-FLIP (Andersson, Nilsson, Shirley and Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic
/// Range Images", 2021): the largest LDR-FLIP over the exposures that show the reference from its brightest
/// pixel to its median (flip_exposures.h). Linear RGB in any unit, finite; negative values count as 0.
/// tests/difference/flip_test.cpp has what the published evaluator, flip_evaluator 1.7, gives: it agrees to
/// 1e-4.
///
/// Throws InputError unless both have width * height pixels, all finite, and the reference is not black.
[[nodiscard]] std::vector<float> flip_map(std::span<const Rgb> image, std::span<const Rgb> reference,
                                          int width, int height);

/// The same at exposures that suit a part of the reference: pixels that are not compared must not choose
/// them.
[[nodiscard]] std::vector<float> flip_map(std::span<const Rgb> image, std::span<const Rgb> reference,
                                          int width, int height, const Exposures& exposures);

/// Mean over pixels: the FLIP value of an image.
[[nodiscard]] double flip_mean(std::span<const float> map);

}  // namespace common
