// How much a photon at some distance from the gather point counts.
#pragma once

#include <cmath>

namespace photonmap {

/// Weight over the unit disc whose mean over the disc is 1, so that the estimate of uniform light is right.
struct DiscKernel {
    [[nodiscard]] float operator()(float /*distance_sq_over_radius_sq*/) const { return 1.0f; }
};

/// Jensen's cone filter: 1 - d / (slope r), divided by its mean 1 - 2 / (3 slope). (Jensen 2001, eq. 7.8)
class ConeKernel {
  public:
    /// `slope` >= 1; 1 falls to zero at the edge, more is flatter.
    explicit ConeKernel(float slope) : slope_(slope) {}

    [[nodiscard]] float operator()(float distance_sq_over_radius_sq) const {
        return (1 - std::sqrt(distance_sq_over_radius_sq) / slope_) / (1 - 2 / (3 * slope_));
    }

  private:
    float slope_;
};

}  // namespace photonmap
