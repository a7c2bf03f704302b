// From the texels that answer for a point to its irradiance.
#pragma once

#include "shlm/basis.h"

namespace shlm {

/// The weighted mean of some texels' irradiance for one normal.
template <Basis B>
class TexelMean {
  public:
    explicit TexelMean(const common::Vec3& shading_normal) : question_(shading_normal) {}

    /// `face_normal` is the texel's.
    void add(const typename B::Numbers& numbers, const common::Vec3& face_normal, float weight) {
        weight_ += weight;
        sum_ += B::irradiance(numbers, face_normal, question_) * weight;
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
    typename B::Question question_;
    float weight_ = 0;
    common::Rgb sum_{0, 0, 0};
};

}  // namespace shlm
