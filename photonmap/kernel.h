// Weights of photons by their distance from the gather point.
#pragma once

#include <cmath>

#include "photonmap/gather_settings.h"

namespace photonmap {

// Weights over the unit disc with a mean of 1 over it, so that the estimate of uniform light is unbiased.

struct DiscKernel {
    [[nodiscard]] float operator()(float /*distance_sq_over_radius_sq*/) const { return 1.0f; }
};

/// Jensen's cone filter with slope 1: 1 - d / r, divided by its mean of 1/3. (Jensen 2001, eq. 7.8; any
/// flatter slope leaves a step at the edge.)
struct ConeKernel {
    [[nodiscard]] float operator()(float distance_sq_over_radius_sq) const {
        return 3 * (1 - std::sqrt(distance_sq_over_radius_sq));
    }
};

/// 1 - (d / r)^2, divided by its mean of 1/2 (Silverman 1986, eq. 4.5).
struct EpanechnikovKernel {
    [[nodiscard]] float operator()(float distance_sq_over_radius_sq) const {
        return 2 * (1 - distance_sq_over_radius_sq);
    }
};

/// Calls `work` with the kernel.
template <class Work>
auto with_kernel(Kernel kernel, Work work) {
    switch (kernel) {
        case Kernel::cone:
            return work(ConeKernel{});
        case Kernel::epanechnikov:
            return work(EpanechnikovKernel{});
        case Kernel::disc:
            break;
    }
    return work(DiscKernel{});
}

}  // namespace photonmap
