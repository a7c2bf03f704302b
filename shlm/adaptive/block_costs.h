// What it costs in error to keep no more of a block than each kind does.
#pragma once

#include "shlm/adaptive/light_pyramid.h"

namespace shlm {

/// Blocks of fewer hits stay whole where they are one surface: what six hits a part say is chance. With more,
/// small surfaces of many shapes lose what tells them apart (atrium); with fewer, noise is kept.
inline constexpr double least_hits_to_divide = 25;
[[nodiscard]] inline bool stays_whole(const LightBlock& block) {
    return block.surface.one && block.hits < least_hits_to_divide;
}

/// Sums over the surface of (error of the irradiance)^2 / (irradiance^2 + epsilon), mean of the channels,
/// times area: world units squared. Estimates, from the light that was summed and from how many hits it is.
struct BlockCosts {
    std::array<float, block_kinds> error_sq{};
};

/// What the estimates need to know of the whole map.
struct LightStatistics {
    /// 0.01 of the squared mean irradiance, as in common::relative_epsilon; W^2/m^4. Not 0 where all is dark.
    double epsilon = 1;
    double noise_of_a_hit = 1;  ///< relative variance of n hits' light, times n; 1 if all hits are alike
};

[[nodiscard]] LightStatistics light_statistics(std::span<const LightPyramid> pyramids);

/// One entry per block, level by level, row by row. Those within a block that stays whole are left at zero:
/// nobody asks for them, and they are most.
///
/// Of a block that becomes one: the error by space is what its texels differ by more than the noise lets
/// them; that of the basis, for the normals in use, is the series of order 2 less the basis's, less what the
/// noise of order 2 brings to that; the noise is that of its hits. What cannot be told from noise is worth
/// nothing here, and what is kept of it costs its noise.
[[nodiscard]] std::vector<BlockCosts> block_costs(const LightPyramid& pyramid, const NormalsInUse& normals,
                                                  const LightStatistics& statistics);

}  // namespace shlm
