// The layout of the compact index: points in leaves of 32, boxes in nodes of 16.
#pragma once

#include <cstddef>
#include <cstdint>

#include "common/core/stable_array.h"

namespace photonmap {

inline constexpr std::size_t points_per_leaf = 32;
inline constexpr std::size_t children_per_node = 16;

/// Lanes without a point hold NaN, which is not within any distance.
struct CompactLeaf {
    float x[points_per_leaf], y[points_per_leaf], z[points_per_leaf];
};

/// Bounding boxes of up to 16 consecutive children, in the nodes or in the leaves.
struct CompactNode {
    float low[3][children_per_node], high[3][children_per_node];
    std::uint32_t first_child;
    std::uint16_t children;
    std::uint16_t has_leaves;  ///< 1: the children are leaves
};

/// Node 0 is the root; there is none without points.
struct CompactTree {
    common::StableArray<CompactLeaf> leaves;
    common::StableArray<CompactNode> nodes;
};

}  // namespace photonmap
