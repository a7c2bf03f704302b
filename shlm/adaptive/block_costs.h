// The errors of keeping no more of a block than each kind does.
#pragma once

#include "shlm/adaptive/light_pyramid.h"

namespace shlm {

/// A block with fewer hits is not divided if it is one surface, as six hits per part are mostly noise. A
/// larger limit loses what distinguishes small surfaces of many shapes (atrium); a smaller one keeps noise.
inline constexpr double least_hits_to_divide = 25;
[[nodiscard]] inline bool stays_whole(const LightBlock& block) {
    return block.surface.one && block.hits < least_hits_to_divide;
}

/// Sums over the surface of (error of the irradiance)^2 / (irradiance^2 + epsilon), mean of the channels,
/// times area: world units squared. They are estimated from the accumulated light and its number of hits.
struct BlockCosts {
    std::array<float, block_kinds> error_sq{};
};

/// Statistics of the whole map that the estimates need.
struct LightStatistics {
    /// 0.01 of the squared mean irradiance, as in common::relative_epsilon; W^2/m^4. Not 0 even if all is
    /// dark.
    double epsilon = 1;
    double noise_of_a_hit = 1;  ///< relative variance of n hits' light, times n; 1 if all hits are alike
};

[[nodiscard]] LightStatistics light_statistics(std::span<const LightPyramid> pyramids);

/// Returns one entry per block, level by level, row by row. Most blocks are within a block that stays whole;
/// their entries are never read and remain zero.
///
/// The error of a kept block has three parts. The spatial error is the variation of its texels beyond the
/// expected noise. The directional error, for the normals in use, is the difference of the basis from
/// F2, less the noise in that difference. The third part is the noise of the
/// block's own hits. Light that cannot be distinguished from noise counts as no error; if it is kept, it
/// costs its noise.
[[nodiscard]] std::vector<BlockCosts> block_costs(const LightPyramid& pyramid, const NormalsInUse& normals,
                                                  const LightStatistics& statistics);

}  // namespace shlm
