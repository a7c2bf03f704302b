// The irradiance at a point from what the texels around it keep.
#pragma once

#include "shlm/basis/basis.h"
#include "shlm/map/irradiance_mean.h"

namespace shlm {

/// The weighted mean over texels. Of a linear basis the numbers and the normals are mixed, as if the texels
/// were one; the basis is evaluated once. Of others the irradiances are mixed.
template <Basis B>
class TexelMix {
  public:
    explicit TexelMix(const common::Vec3& shading_normal) : shading_normal_(shading_normal) {}

    void add(const typename B::Numbers& numbers, const common::Vec3& face_normal, float weight) {
        if constexpr (B::linear) {
            weight_ += weight;
            for (std::size_t i = 0; i < numbers.size(); ++i) sum_[i] += numbers[i] * weight;
            normal_ += face_normal * weight;
        } else {
            mean_.add(B::irradiance(numbers, face_normal, shading_normal_), weight);
        }
    }

    /// Returns irradiance in the unit of the numbers of light. Negative values are clamped to 0. Zero if
    /// nothing was added.
    [[nodiscard]] common::Rgb irradiance() const {
        if constexpr (B::linear) {
            IrradianceMean sum;
            if (weight_ > 0) sum.add(B::irradiance(sum_, normal_.normalized(), shading_normal_) / weight_, 1);
            return sum.irradiance();
        } else {
            return mean_.irradiance();
        }
    }

  private:
    common::Vec3 shading_normal_;
    float weight_ = 0;
    typename B::Numbers sum_{};
    common::Vec3 normal_{0, 0, 0};
    IrradianceMean mean_;
};

}  // namespace shlm
