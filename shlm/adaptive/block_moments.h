// The light of an adaptive map's block as HemisphereFit<2> keeps it, which other programs evaluate.
#pragma once

#include "shlm/adaptive/block_kind.h"

namespace shlm {

// Each function returns the light whose fit of order 2 is what a basis keeps, in the unit of its numbers of
// light. `normal` is that of the block, N below.

/// Uniform light from above, of that irradiance at the normal. Exact.
[[nodiscard]] inline TexelLight<2> uniform_moments(const common::Rgb& irradiance,
                                                   const common::Vec3& normal) {
    using namespace sh_constants;
    TexelLight<2> light;
    light.fill(common::Rgb(0, 0, 0));
    light[0] = irradiance / (2 * c0);
    light[1] = irradiance * (normal.y / (2 * c1));
    light[2] = irradiance * (normal.z / (2 * c1));
    light[3] = irradiance * (normal.x / (2 * c1));
    return light;
}

[[nodiscard]] inline TexelLight<2> moments_of(HemisphereFit<0>, const HemisphereFit<0>::Numbers& numbers,
                                              const common::Vec3& normal) {
    return uniform_moments(rgb_at(numbers, 0), normal);
}

/// Radiance offset + slope . w, W/m^2/sr, over the hemisphere above a surface.
struct LinearRadiance {
    float offset;
    common::Vec3 slope;

    /// The fit of order 1 in closed form: with M the integral of radiance and V that of radiance times
    /// direction, offset = (2 M - 3 V.N) / pi, slope.N = (6 V.N - 3 M) / pi, and the rest of the slope is
    /// 3 / (2 pi) that of V. `coefficients` are those of irradiance.
    LinearRadiance(const std::array<float, 4>& coefficients, const common::Vec3& normal) {
        constexpr float pi = std::numbers::pi_v<float>;
        const float integral = 4 * sh_constants::c0 * coefficients[0];
        const common::Vec3 first =
            common::Vec3(coefficients[3], coefficients[1], coefficients[2]) * (2 * sh_constants::c1);
        const float own = first.dot(normal);
        offset = (2 * integral - 3 * own) / pi;
        slope = (first * 1.5f + normal * (4.5f * own - 3 * integral)) / pi;
    }

    /// Returns coefficients of irradiance. Over the hemisphere, with b the slope and t the part of b that is
    /// perpendicular to N, the integrals of the radiance times 1, w and w w^T - I / 3 are
    ///
    ///     2 pi offset + pi b.N,    pi offset N + 2 pi / 3 b,
    ///     pi b.N (N N^T / 4 - I / 12) + pi / 4 (t N^T + N t^T).
    [[nodiscard]] std::array<float, 9> moments(const common::Vec3& normal) const {
        using namespace sh_constants;
        constexpr float pi = std::numbers::pi_v<float>;
        const float along = slope.dot(normal);
        const common::Vec3 across = slope - normal * along;
        const common::Vec3 first = normal * (pi * offset) + slope * (2 * pi / 3);
        const auto second = [&](int i, int j) {
            return pi / 4 * (along * normal[i] * normal[j] + across[i] * normal[j] + normal[i] * across[j]) -
                   (i == j ? pi / 12 * along : 0);
        };
        std::array<float, 9> moment = {c0 * (2 * pi * offset + pi * along),
                                       c1 * first.y,
                                       c1 * first.z,
                                       c1 * first.x,
                                       c2 * second(0, 1),
                                       c2 * second(1, 2),
                                       3 * c20 * second(2, 2),
                                       c2 * second(0, 2),
                                       c22 * (second(0, 0) - second(1, 1))};
        for (std::size_t i = 0; i < moment.size(); ++i) moment[i] *= cosine_factors<2>[i];
        return moment;
    }
};

/// Exact, as that radiance is in the span of order 2.
[[nodiscard]] inline TexelLight<2> moments_of(HemisphereFit<1>, const HemisphereFit<1>::Numbers& numbers,
                                              const common::Vec3& normal) {
    TexelLight<2> light;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::array<float, 4> channel = {numbers[c], numbers[3 + c], numbers[6 + c], numbers[9 + c]};
        const std::array<float, 9> moments = LinearRadiance(channel, normal).moments(normal);
        for (std::size_t i = 0; i < light.size(); ++i) light[i][static_cast<int>(c)] = moments[i];
    }
    return light;
}

[[nodiscard]] inline TexelLight<2> moments_of(HemisphereFit<2>, const HemisphereFit<2>::Numbers& numbers,
                                              const common::Vec3&) {
    TexelLight<2> light;
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = rgb_at(numbers, 3 * i);
    return light;
}

[[nodiscard]] inline TexelLight<2> moments_of(LuminanceFit<2>, const LuminanceFit<2>::Numbers& numbers,
                                              const common::Vec3&) {
    const common::Rgb colour = LuminanceFit<2>::colour(numbers);
    TexelLight<2> light;
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = colour * numbers[i];
    return light;
}

/// The uniform light and the distant light that AD stands for. The fit of order 2 smooths the distant one;
/// it is exact for the block's own normal.
[[nodiscard]] inline TexelLight<2> moments_of(AmbientAndDirection,
                                              const AmbientAndDirection::Numbers& numbers,
                                              const common::Vec3& normal) {
    const common::Rgb own = rgb_at(numbers, 0);
    const common::Vec3 direct = rgb_at(numbers, 3);
    const float strength = direct.length();
    TexelLight<2> light = uniform_moments(own * (1 - direct.dot(normal)), normal);
    if (strength == 0) return light;
    const ShValues<2> y = evaluate_sh<2>(direct / strength);
    for (std::size_t i = 0; i < light.size(); ++i) light[i] += own * (strength * cosine_factors<2>[i] * y[i]);
    return light;
}

}  // namespace shlm
