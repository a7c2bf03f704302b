// What a viewer perceives of one displayed image, in FLIP's model (Andersson et al. 2020, section 4).
#pragma once

#include <span>
#include <vector>

#include "common/difference/flip_colors.h"
#include "common/difference/flip_filters.h"

namespace common {

/// Strength of an edge and of a point at a pixel, 0 to about 1.
struct Features {
    float edge = 0, point = 0;
};

/// One value per pixel, row by row.
struct PerceivedImage {
    std::vector<HuntLab> color;  ///< blurred by the contrast filters
    std::vector<Features> features;
};

struct FlipFilters {
    ContrastFilters contrast;
    FeatureFilters feature;
};

/// `displayed`: linear RGB, 0 to 1, `width` times `height` pixels row by row.
[[nodiscard]] PerceivedImage perceived(std::span<const Rgb> displayed, int width, int height,
                                       const FlipFilters& filters);

}  // namespace common
