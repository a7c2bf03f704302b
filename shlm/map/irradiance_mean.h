// The irradiance at a point from that of all texels that contribute to it.
#pragma once

#include <algorithm>

#include "common/core/vector.h"

namespace shlm {

/// The weighted mean of irradiances that may be negative.
class IrradianceMean {
  public:
    void add(const common::Rgb& irradiance, float weight) {
        weight_ += weight;
        sum_ += irradiance * weight;
    }

    /// Returns the mean. Negative values of the truncated series are clamped to 0. Zero if nothing was added.
    [[nodiscard]] common::Rgb irradiance() const {
        common::Rgb result(0, 0, 0);
        if (weight_ == 0) return result;
        for (int c = 0; c < 3; ++c) result[c] = std::max(sum_[c], 0.0f) / weight_;
        return result;
    }

  private:
    float weight_ = 0;
    common::Rgb sum_{0, 0, 0};
};

}  // namespace shlm
