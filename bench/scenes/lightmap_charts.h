// Packs the charts of one mesh into its lightmap: rectangles in the unit square.
#pragma once

#include <span>
#include <vector>

#include "common/core/vector.h"

namespace scenes {

using common::Vec2;

/// Free space around every chart, as a fraction of the unit square: a whole texel of a 128 x 128 region
/// between any two charts.
inline constexpr float chart_gutter = 1.0f / 128.0f;

struct ChartPlacement {
    Vec2 offset;           ///< corner with the smallest coordinates, in the unit square
    bool rotated = false;  ///< by a quarter turn: (x, y) of the chart becomes (height - y, x)
};

struct ChartPacking {
    std::vector<ChartPlacement> placement;  ///< one per chart, in the order given
    Vec2 scale{0, 0};  ///< unit squares per metre, after rotation; the same for all charts
};

/// Packs charts of the given width and height (metres, > 0) as large as one common scale allows. The two
/// components of the scale differ by at most 30%, so texels may be that far from square.
[[nodiscard]] ChartPacking pack_charts(std::span<const Vec2> chart_size);

}  // namespace scenes
