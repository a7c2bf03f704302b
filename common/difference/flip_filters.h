// The filters of FLIP (Andersson et al. 2020, sections 4.1 and 4.2): contrast sensitivity and features.
#pragma once

#include "common/difference/plane.h"

namespace common {

/// A separable part of a filter, the same along rows and columns, with weights that sum to 1.
struct WeightedKernel {
    float weight;
    Kernel kernel;
};

/// The eye's contrast sensitivity as a filter for each opponent colour: a sum of Gaussians, normalised to 1.
struct ContrastFilters {
    WeightedKernel y, cx;
    WeightedKernel cz_narrow, cz_wide;  ///< the filter is the sum of the two
};

[[nodiscard]] ContrastFilters contrast_filters(float pixels_per_degree);

/// A Gaussian and its first two derivatives across an edge. The positive weights of a derivative sum to 1,
/// the negative ones to -1.
struct FeatureFilters {
    Kernel gaussian, edge, point;
};

[[nodiscard]] FeatureFilters feature_filters(float pixels_per_degree);

}  // namespace common
