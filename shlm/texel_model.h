// What a texel keeps of its light, and how that becomes irradiance.
#pragma once

#include "common/estimator/irradiance_estimator.h"
#include "shlm/settings.h"
#include "shlm/sh_basis.h"

namespace shlm {

/// Harmonics up to `Order`, with the given weight for each hit. Order 0 normalised is what a traditional
/// light map stores: the irradiance of the surface, the same for all normals.
template <int Order, ShWeight Weight>
struct TexelModel {
    static constexpr int order = Order;
    static constexpr ShWeight weight = Weight;

    static constexpr bool keeps_surface_irradiance = Weight == ShWeight::normalised;
    /// Of a flat shape the surface's irradiance is all there is to know.
    static constexpr std::size_t harmonics =
        keeps_surface_irradiance && Order == 0 ? 0 : harmonic_count(Order);
    /// Numbers per texel and channel: the harmonics' coefficients, then the surface's irradiance where it is
    /// kept.
    static constexpr std::size_t stored = harmonics + keeps_surface_irradiance;

    using Values = std::array<float, stored>;

    /// What a hit of 1 W on 1 m^2 adds to the stored numbers. `inverse_cosine`: of incidence, clamped.
    [[nodiscard]] static Values of_hit(const common::Vec3& towards_light, float inverse_cosine) {
        Values values;
        if constexpr (harmonics > 0) {
            const ShValues<Order> y = evaluate_sh<Order>(towards_light);
            const float scale = Weight == ShWeight::flux ? 1.0f : inverse_cosine;
            for (std::size_t i = 0; i < harmonics; ++i) values[i] = y[i] * scale;
        }
        if constexpr (keeps_surface_irradiance) values[harmonics] = 1;
        return values;
    }

    /// Turns a stored sum into what a finished texel holds: coefficients of irradiance by normal.
    [[nodiscard]] static constexpr float finishing_factor(std::size_t stored_index) {
        return stored_index < harmonics ? cosine_factors<Order>[stored_index] : 1.0f;
    }
};

/// Numbers of one finished texel: W/m^2 per harmonic, then W/m^2 on the surface where that is kept.
template <class Model>
using TexelLight = std::array<common::Rgb, Model::stored>;

/// The truncated series at `normal`, W/m^2; may be negative.
template <class Model>
[[nodiscard]] common::Rgb evaluate_series(const TexelLight<Model>& light, const ShValues<Model::order>& y) {
    common::Rgb sum(0, 0, 0);
    for (std::size_t i = 0; i < Model::harmonics; ++i) sum += light[i] * y[i];
    return sum;
}

/// The weighted mean of some texels' irradiance at one point.
template <class Model>
class TexelMean {
  public:
    /// All texels are asked for the same normals: one evaluation of the harmonics serves them.
    TexelMean(const common::Vec3& shading_normal, const common::Vec3& geometric_normal)
        : at_shading_normal_(evaluate_sh<Model::order>(shading_normal)),
          at_geometric_normal_(evaluate_sh<Model::order>(geometric_normal)) {}

    void add(const TexelLight<Model>& light, float weight) {
        weight_ += weight;
        shading_ += evaluate_series<Model>(light, at_shading_normal_) * weight;
        if constexpr (Model::keeps_surface_irradiance) {
            geometric_ += evaluate_series<Model>(light, at_geometric_normal_) * weight;
            surface_ += light[Model::harmonics] * weight;
        }
    }

    /// Never negative: what the truncated series takes below zero is cut off. Zero where nothing was added.
    [[nodiscard]] common::Rgb irradiance() const {
        common::Rgb result(0, 0, 0);
        if (weight_ == 0) return result;
        for (int c = 0; c < 3; ++c) result[c] = std::max(channel(c), 0.0f) / weight_;
        return result;
    }

    /// The same before anything is cut off.
    [[nodiscard]] common::Rgb series() const {
        common::Rgb result(0, 0, 0);
        if (weight_ == 0) return result;
        for (int c = 0; c < 3; ++c) result[c] = channel(c) / weight_;
        return result;
    }

  private:
    [[nodiscard]] float channel(int c) const {
        if constexpr (!Model::keeps_surface_irradiance) return shading_[c];
        if constexpr (Model::harmonics == 0) return surface_[c];
        // Light from above the surface gives a series that is positive there.
        return geometric_[c] > 0 ? surface_[c] * (shading_[c] / geometric_[c]) : surface_[c];
    }

    ShValues<Model::order> at_shading_normal_, at_geometric_normal_;
    float weight_ = 0;
    common::Rgb shading_{0, 0, 0}, geometric_{0, 0, 0}, surface_{0, 0, 0};
};

}  // namespace shlm
