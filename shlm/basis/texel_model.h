// The sums of light in a texel, and their conversion to harmonics of irradiance.
#pragma once

#include "common/estimator/irradiance_estimator.h"
#include "shlm/basis/sh_basis.h"
#include "shlm/basis/weight.h"

namespace shlm {

/// Harmonics up to `Order`, with the given weight for each hit. Order 0 normalised is a traditional light
/// map: it stores the irradiance of the surface, the same for all normals.
template <int Order, ShWeight Weight>
struct TexelModel {
    static constexpr int order = Order;
    static constexpr ShWeight weight = Weight;

    /// Number of harmonics of the finished light, per channel.
    static constexpr std::size_t harmonics = harmonic_count(Order);

    static constexpr bool sums_surface_irradiance = Weight == ShWeight::normalised;
    /// With a constant shape, the surface's irradiance is all that must be summed.
    static constexpr std::size_t summed_harmonics = sums_surface_irradiance && Order == 0 ? 0 : harmonics;
    /// Numbers summed per texel and channel: the harmonics' coefficients, then the surface's irradiance if
    /// the shape is scaled to it.
    static constexpr std::size_t summed = summed_harmonics + sums_surface_irradiance;

    using Values = std::array<float, summed>;

    /// Returns what a hit of 1 W on 1 m^2 adds to the sums. `inverse_cosine` is that of incidence, clamped.
    [[nodiscard]] static Values of_hit(const common::Vec3& towards_light, float inverse_cosine) {
        Values values;
        if constexpr (summed_harmonics > 0) {
            const ShValues<Order> y = evaluate_sh<Order>(towards_light);
            const float scale = Weight == ShWeight::flux ? 1.0f : inverse_cosine;
            for (std::size_t i = 0; i < harmonics; ++i) values[i] = y[i] * scale;
        }
        if constexpr (sums_surface_irradiance) values[summed_harmonics] = 1;
        return values;
    }

    /// Returns an upper bound of the magnitudes of such a hit's numbers, with at least a hundredth to spare.
    [[nodiscard]] static float largest_of_hit(float inverse_cosine) {
        constexpr float one = 1.02f;
        if (summed_harmonics == 0) return one;
        constexpr float largest_harmonic = Order == 0   ? 0.29f
                                           : Order == 1 ? 0.50f
                                           : Order == 2 ? 0.64f
                                                        : 0.86f;
        const float shape = Weight == ShWeight::flux ? largest_harmonic : largest_harmonic * inverse_cosine;
        return sums_surface_irradiance ? std::max(one, shape) : shape;
    }

    /// Returns the factor from a summed coefficient of radiance to one of irradiance by normal.
    [[nodiscard]] static constexpr float finishing_factor(std::size_t harmonic) {
        return cosine_factors<Order>[harmonic];
    }
};

/// The light of one finished texel, W/m^2: coefficients of irradiance by normal, one for each harmonic.
template <int Order>
using TexelLight = std::array<common::Rgb, harmonic_count(Order)>;

/// Returns the truncated series for the normal that `y` was evaluated at, W/m^2; may be negative.
template <int Order>
[[nodiscard]] common::Rgb evaluate_series(const TexelLight<Order>& light, const ShValues<Order>& y) {
    common::Rgb sum(0, 0, 0);
    for (std::size_t i = 0; i < light.size(); ++i) sum += light[i] * y[i];
    return sum;
}

/// The largest ratio of a surface's irradiance to its truncated series, for light from above. This is the
/// maximum of x / kernel(x). The kernel is 1/4 + x/2 for order 1 and (3 + 16 x + 15 x^2) / 32 for order 2.
/// That of order 4 is 3 (35 x^4 - 30 x^2 + 3) / 256 less than that of order 2. Only a texel with varying
/// normals can exceed it: some of its light comes from below its mean normal, where the kernel has zeros.
template <int Order>
inline constexpr float largest_surface_share = Order == 1   ? 4.0f / 3
                                               : Order == 2 ? 1.087829f
                                                            : 1.075401f;

/// Converts the sums of a texel to its light. `mean` is the sums divided by area and photons, W/m^2; `normal`
/// is that of the face.
template <class Model>
[[nodiscard]] TexelLight<Model::order> finished_light(const std::array<common::Rgb, Model::summed>& mean,
                                                      const common::Vec3& normal) {
    TexelLight<Model::order> light;
    light.fill(common::Rgb(0, 0, 0));
    for (std::size_t i = 0; i < Model::summed_harmonics; ++i) light[i] = mean[i] * Model::finishing_factor(i);
    if constexpr (Model::sums_surface_irradiance) {
        // Here and not where texels are gathered: for the face of a neighbour the ratio would have no bound.
        const ShValues<Model::order> y = evaluate_sh<Model::order>(normal);
        const common::Rgb series = evaluate_series<Model::order>(light, y),
                          surface = mean[Model::summed_harmonics];
        for (int c = 0; c < 3; ++c) {
            const float ratio =
                series[c] > 0 ? std::min(surface[c] / series[c], largest_surface_share<Model::order>) : 0;
            for (common::Rgb& coefficient : light) coefficient[c] *= ratio;
            if (ratio == 0) light[0][c] = surface[c] / y[0];  // no shape: constant over all normals
        }
    }
    return light;
}

}  // namespace shlm
