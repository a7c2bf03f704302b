// How far an image is from a reference, in numbers.
#pragma once

#include <cstddef>
#include <span>

#include "common/core/vector.h"

namespace common {

/// Where the relative error is largest.
struct WorstValue {
    std::size_t pixel = 0;  ///< its place in the spans
    int channel = 0;
    float image = 0, reference = 0;
};

/// I is the image, R the reference; every mean is over all pixels and their three channels.
struct DifferenceFigures {
    float epsilon = 0;              ///< relative_epsilon(R), the square of the images' unit
    double mean_image = 0;          ///< mean I
    double mean_reference = 0;      ///< mean R
    double relmse = 0;              ///< mean (I - R)^2 / (R^2 + epsilon)
    double relative_rms = 0;        ///< its root
    double rmse = 0;                ///< root of mean (I - R)^2
    double smape = 0;               ///< mean 2 |I - R| / (|I| + |R| + sqrt(epsilon)), 0 to 2
    double bias = 0;                ///< mean I - mean R
    double relative_bias = 0;       ///< mean I / mean R - 1
    double relative_error_p99 = 0;  ///< of |I - R| / sqrt(R^2 + epsilon): 99 % of all values have no more
    double relative_error_max = 0;  ///< the largest of these
    WorstValue worst;               ///< the first that has it
    double worst_share = 0;         ///< of relmse: the part of the thousandth of all pixels that has most
};

/// What keeps relative errors of dark pixels in bounds: 0.01 (mean R)^2. Throws InputError where it is no
/// finite number above 0, for instance for a black reference: no error is relative to nothing.
[[nodiscard]] float relative_epsilon(std::span<const Rgb> reference);

/// Throws InputError unless there are as many pixels in both, at least one, all finite, and relative_epsilon
/// is as it should be.
[[nodiscard]] DifferenceFigures difference(std::span<const Rgb> image, std::span<const Rgb> reference);

}  // namespace common
