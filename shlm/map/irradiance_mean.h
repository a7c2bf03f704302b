// From the irradiance of all texels that answer for a point to the point's.
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

    /// Never negative: what the truncated series takes below zero is cut off. Zero where nothing was added.
    [[nodiscard]] common::Rgb irradiance() const {
        common::Rgb result(0, 0, 0);
        if (weight_ == 0) return result;
        for (int c = 0; c < 3; ++c) result[c] = std::max(sum_[c], 0.0f) / weight_;
        return result;
    }

    /// The same before anything is cut off.
    [[nodiscard]] common::Rgb series() const { return weight_ == 0 ? common::Rgb(0, 0, 0) : sum_ / weight_; }

  private:
    float weight_ = 0;
    common::Rgb sum_{0, 0, 0};
};

}  // namespace shlm
