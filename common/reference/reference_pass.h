// The visible points of an image, sampled pass after pass.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/reference/lights.h"
#include "common/reference/path.h"
#include "common/reference/running_mean.h"
#include "common/view/visible_surfaces.h"

namespace common::reference {

/// What whole passes have given so far.
struct ReferenceSums {
    std::uint64_t passes = 0;                       ///< of samples_per_pass each
    std::uint64_t dropped = 0;                      ///< samples that were not finite and count as 0
    std::vector<std::array<RunningMean, 3>> pixel;  ///< irradiance, W/m^2; 0 where no diffuse surface is seen

    explicit ReferenceSums(std::size_t pixels) : pixel(pixels) {}
};

/// Asked between parts of a pass with the number of pixels done; false gives the pass up.
using PassProgress = std::function<bool(std::size_t pixels_done)>;

/// Adds pass number `sums.passes` of the run with this seed and returns true; or, given up, adds nothing and
/// returns false. The sums depend on the scene, the points, the seed and the number of passes alone, not on
/// threads. Paths end at `most_surfaces`.
bool add_pass(const RayScene& rays, const Lights& lights, std::span<const VisibleSurface> pixels,
              std::uint64_t seed, ReferenceSums& sums, const PassProgress& progress,
              int most_surfaces = max_surfaces);

/// Square root of the mean, over points and channels, of variance / (R^2 + eps), where R is irradiance and
/// eps a hundredth of the square of its mean: the relative error to be expected of a point, with dark points
/// not asked for more than others. 0 where no light arrives.
[[nodiscard]] double relative_error(std::span<const VisibleSurface> pixels, const ReferenceSums& sums);

}  // namespace common::reference
