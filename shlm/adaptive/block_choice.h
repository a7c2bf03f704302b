// The smallest set of blocks that has the wanted estimated error.
#pragma once

#include "shlm/adaptive/block_costs.h"

namespace shlm {

/// Marks a block that is divided into the four below it; others are kept as one of a kind.
inline constexpr std::uint8_t divided = 0xff;

struct BlockChoice {
    std::vector<std::uint8_t> of_block;  ///< a BlockKind or `divided`, in the order of block_costs()
    double error_sq = 0;                 ///< summed as BlockCosts::error_sq
};

/// Returns the bytes that a block costs in the finished map (adaptive_map.h) if it is kept as one of a kind,
/// with its normal if the face is not flat. bytes_of_division is the cost of dividing it.
[[nodiscard]] double bytes_of(BlockKind kind, bool with_normal);
inline constexpr double bytes_of_division = 16;

/// Minimises error + byte_price * bytes over all ways to divide the face. A block is divided if its parts
/// together cost less (Breiman et al., "Classification and Regression Trees", 1984, ch. 3). `byte_price` is
/// in units of the error, per byte.
[[nodiscard]] BlockChoice choose_blocks(const LightPyramid& pyramid, std::span<const BlockCosts> costs,
                                        double byte_price);

}  // namespace shlm
