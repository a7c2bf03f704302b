// The light of an adaptive map's block as harmonics of order 2, which other programs evaluate.
#pragma once

#include "shlm/adaptive/light_ladder.h"

namespace shlm {

/// Returns the light that does not depend on the normal.
[[nodiscard]] inline TexelLight<2> constant_series(const common::Rgb& irradiance) {
    TexelLight<2> series;
    series.fill(common::Rgb(0, 0, 0));
    series[0] = irradiance / sh_constants::c0;
    return series;
}

/// Returns constant + x n.x + y n.y + z n.z, n being the normal.
[[nodiscard]] inline TexelLight<2> linear_series(const common::Rgb& constant, const common::Rgb& x,
                                                 const common::Rgb& y, const common::Rgb& z) {
    TexelLight<2> series = constant_series(constant);
    series[1] = y / sh_constants::c1;
    series[2] = z / sh_constants::c1;
    series[3] = x / sh_constants::c1;
    return series;
}

// Each returns the harmonics of what a basis keeps, in the unit of its numbers of light. `normal` is that of
// the block.

/// Exact.
[[nodiscard]] inline TexelLight<2> series_of(Harmonics<2>, const Harmonics<2>::Numbers& numbers,
                                             const common::Vec3&) {
    TexelLight<2> series;
    for (std::size_t i = 0; i < series.size(); ++i) series[i] = rgb_at(numbers, 3 * i);
    return series;
}

/// Exact.
[[nodiscard]] inline TexelLight<2> series_of(HemisphereFour, const HemisphereFour::Numbers& numbers,
                                             const common::Vec3&) {
    return linear_series(rgb_at(numbers, 0), rgb_at(numbers, 3), rgb_at(numbers, 6), rgb_at(numbers, 9));
}

/// Exact.
[[nodiscard]] inline TexelLight<2> series_of(LuminanceNine, const LuminanceNine::Numbers& numbers,
                                             const common::Vec3& normal) {
    const ShValues<2> y = evaluate_sh<2>(normal);
    const common::Rgb own = rgb_at(numbers, 0);
    TexelLight<2> series = constant_series(own);
    for (std::size_t i = 1; i < series.size(); ++i) {
        series[i] = own * numbers[2 + i];
        series[0] -= series[i] * (y[i] / y[0]);
    }
    return series;
}

/// Exact for the block's own normal. The distant light's clamped cosine is truncated after band 2, which
/// differs from it by up to 3/32 of its irradiance (at a right angle) before the own normal is set right.
[[nodiscard]] inline TexelLight<2> series_of(AmbientAndDirection, const AmbientAndDirection::Numbers& numbers,
                                             const common::Vec3& normal) {
    const common::Rgb own = rgb_at(numbers, 0);
    const common::Vec3 direct = rgb_at(numbers, 3);
    const common::Rgb from_above = own * ((1 - direct.dot(normal)) / 2);
    const float strength = direct.length();
    TexelLight<2> series =
        linear_series(from_above, from_above * normal.x, from_above * normal.y, from_above * normal.z);
    if (strength > 0) {
        const ShValues<2> y = evaluate_sh<2>(direct / strength);
        for (std::size_t i = 0; i < series.size(); ++i)
            series[i] += own * (strength * cosine_factors<2>[i] * y[i]);
    }
    const ShValues<2> at_own = evaluate_sh<2>(normal);
    series[0] += (own - evaluate_series<2>(series, at_own)) / at_own[0];
    return series;
}

}  // namespace shlm
