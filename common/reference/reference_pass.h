// Samples the visible points of an image, pass after pass.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/reference/lights.h"
#include "common/reference/path.h"
#include "common/reference/running_mean.h"
#include "common/view/visible_surfaces.h"

namespace common::reference {

/// The results of all complete passes so far.
struct ReferenceSums {
    std::uint64_t passes = 0;                       ///< of samples_per_pass each
    std::uint64_t dropped = 0;                      ///< samples that were not finite and count as 0
    std::vector<std::array<RunningMean, 3>> pixel;  ///< irradiance, W/m^2; 0 where no diffuse surface is seen

    explicit ReferenceSums(std::size_t pixels) : pixel(pixels) {}
};

/// Called between parts of a pass with the number of pixels done; returns false to abandon the pass.
using PassProgress = std::function<bool(std::size_t pixels_done)>;

/// Adds pass number `sums.passes` of the run with this seed and returns true. If abandoned, adds nothing and
/// returns false. The sums depend only on the scene, the points, the seed and the number of passes, not on
/// threads. Paths end at `most_surfaces`.
bool add_pass(const RayScene& rays, const Lights& lights, std::span<const VisibleSurface> pixels,
              std::uint64_t seed, ReferenceSums& sums, const PassProgress& progress,
              int most_surfaces = max_surfaces);

/// Returns the square root of the mean, over points and channels, of variance / (R^2 + eps), where R is
/// irradiance and eps a hundredth of the square of its mean. This is the expected relative error of a point;
/// eps keeps dark points from dominating. Returns 0 if no light arrives.
[[nodiscard]] double relative_error(std::span<const VisibleSurface> pixels, const ReferenceSums& sums);

}  // namespace common::reference
