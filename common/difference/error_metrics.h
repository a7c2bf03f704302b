// Error metrics of an image against a reference.
#pragma once

#include <cstddef>
#include <span>

#include "common/core/vector.h"

namespace common {

/// The value with the largest relative error.
struct WorstValue {
    std::size_t pixel = 0;  ///< index into the spans
    int channel = 0;
    float image = 0, reference = 0;
};

/// I is the image, R the reference; every mean is over all pixels and their three channels.
struct DifferenceFigures {
    float epsilon = 0;              ///< relative_epsilon(R), in the squared unit of the images
    double mean_image = 0;          ///< mean I
    double mean_reference = 0;      ///< mean R
    double relmse = 0;              ///< mean (I - R)^2 / (R^2 + epsilon)
    double relative_rms = 0;        ///< root of relmse
    double rmse = 0;                ///< root of mean (I - R)^2
    double smape = 0;               ///< mean 2 |I - R| / (|I| + |R| + sqrt(epsilon)), 0 to 2
    double bias = 0;                ///< mean I - mean R
    double relative_bias = 0;       ///< mean I / mean R - 1
    double relative_error_p99 = 0;  ///< 99th percentile of |I - R| / sqrt(R^2 + epsilon)
    double relative_error_max = 0;  ///< maximum of the same
    WorstValue worst;               ///< the first value that has this maximum
    double worst_share = 0;         ///< share of relmse in the worst thousandth of all pixels
};

/// Returns the constant that bounds the relative errors of dark pixels: 0.01 (mean R)^2. Throws InputError if
/// it is not a finite number above 0, for instance for a black reference.
[[nodiscard]] float relative_epsilon(std::span<const Rgb> reference);

/// Compares an image with a reference. Throws InputError unless both have the same number of pixels, at least
/// one, all finite; and as relative_epsilon() does.
[[nodiscard]] DifferenceFigures difference(std::span<const Rgb> image, std::span<const Rgb> reference);

}  // namespace common
