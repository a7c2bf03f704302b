// The colour spaces of FLIP (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020,
// section 4.1), all relative to the white of the display, linear RGB (1, 1, 1).
#pragma once

#include "common/core/vector.h"

namespace common {

/// YyCxCz: opponent colours that are linear in light, so that they can be filtered.
struct OpponentColor {
    float y = 0;   ///< black to white: -16 to 100
    float cx = 0;  ///< green to red
    float cz = 0;  ///< blue to yellow
};

/// CIE L*a*b* whose a and b are scaled by 0.01 L: colours count for less where it is dark (the Hunt effect).
struct HuntLab {
    float lightness = 0;  ///< 0 to 100
    float a = 0, b = 0;
};

/// Converts linear RGB with Rec. 709 primaries, in which 1 is the display's white.
[[nodiscard]] OpponentColor opponent_color(const Rgb& linear);

/// Returns the colour as linear RGB, clamped to what a display can show, 0 to 1.
[[nodiscard]] Rgb displayed_color(const OpponentColor& color);

[[nodiscard]] HuntLab hunt_lab(const Rgb& linear);

/// Returns HyAB, made for large differences (Abasi, Amani Tehran and Fairchild, "Distance Metrics for Very
/// Large Color Differences", 2020): the difference in lightness plus the distance in the plane of a and b.
[[nodiscard]] float hyab_distance(const HuntLab& p, const HuntLab& q);

}  // namespace common
