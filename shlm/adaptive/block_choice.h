// The smallest set of blocks whose estimated error is what is wanted.
#pragma once

#include "shlm/adaptive/block_costs.h"

namespace shlm {

/// What becomes of a block: divided into the four below it, or kept as one of a kind.
inline constexpr std::uint8_t divided = 0xff;

struct BlockChoice {
    std::vector<std::uint8_t> of_block;  ///< a BlockKind or `divided`, as block_costs has its blocks
    double error_sq = 0;                 ///< summed as BlockCosts::error_sq
};

/// Bytes that a block costs in the finished map (adaptive_map.h) when it is kept as one of a kind, with its
/// normal where the face is not flat, and when it is divided.
[[nodiscard]] double bytes_of(BlockKind kind, bool with_normal);
inline constexpr double bytes_of_division = 16;

/// The least of error + byte_price * bytes over all ways to divide the face: each block is worth dividing
/// where its parts together cost less (Breiman et al., "Classification and Regression Trees", 1984, ch. 3).
/// `byte_price`: in units of the error, per byte.
[[nodiscard]] BlockChoice choose_blocks(const LightPyramid& pyramid, std::span<const BlockCosts> costs,
                                        bool with_normals, double byte_price);

}  // namespace shlm
