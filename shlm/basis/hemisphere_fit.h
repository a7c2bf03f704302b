// F0, F1, F2: the radiance that fits the sums best over the hemisphere above the surface.
#pragma once

#include "shlm/basis/clamped_cosine.h"
#include "shlm/basis/harmonics.h"

namespace shlm {

/// Returns what to multiply coefficients of irradiance by (TexelLight) to get the irradiance of the fit, from
/// the clamped cosine as it is fitted.
template <int Order>
[[nodiscard]] inline ShValues<Order> fitted_factors(const DirectionPolynomial& clamped_cosine) {
    ShValues<Order> factors = clamped_cosine.harmonics<Order>();
    for (std::size_t i = 0; i < factors.size(); ++i) factors[i] /= cosine_factors<Order>[i];
    return factors;
}
template <int Order>
[[nodiscard]] inline ShValues<Order> fitted_factors(const common::Vec3& face_normal,
                                                    const common::Vec3& shading_normal) {
    return fitted_factors<Order>(fitted_clamped_cosine<Order>(face_normal, shading_normal));
}

/// Keeps the same numbers as Harmonics of that order. Light from below the surface is known to be zero, which
/// the harmonics ignore. Exact for uniform light from above and, for any light, at the surface's own normal.
///
/// The hemisphere is that of each texel which answers, not that of the triangle under the point: where a
/// texel covers a curved surface, light comes from below that, and the fit has no bounds there. For the same
/// reason texels are fitted one by one: their numbers mixed and fitted once had the larger error (atrium).
template <int Order>
struct HemisphereFit {
    static_assert(Order == 1 || Order == 2);
    static constexpr int order = Order;
    using Numbers = typename Harmonics<Order>::Numbers;
    static constexpr std::size_t light_numbers = Harmonics<Order>::light_numbers;
    static constexpr std::string_view formula =
        "E(n) = sum over i of sh.i q_i / A_i; A = pi, 2 pi / 3, pi / 4 for bands 0, 1, 2; q_i are the "
        "factors of "
        "the orthonormal real spherical harmonics, m from -l to l, without the Condon-Shortley sign, in the "
        "least squares fit of max(w.n, 0) over the directions w with w.N > 0";

    [[nodiscard]] static std::string number_name(std::size_t i) { return Harmonics<Order>::number_name(i); }

    struct Question {
        explicit Question(const common::Vec3& shading_normal) : normal(shading_normal) {}
        common::Vec3 normal;
    };

    [[nodiscard]] static Numbers numbers_of(const TexelLight<Order>& light, const common::Vec3& normal) {
        return Harmonics<Order>::numbers_of(light, normal);
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        return irradiance(numbers, fitted_factors<Order>(face_normal, question.normal));
    }

    /// As above, with the factors of the two normals.
    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const ShValues<Order>& factors) {
        common::Rgb sum(0, 0, 0);
        for (std::size_t i = 0; i < factors.size(); ++i) sum += rgb_at(numbers, 3 * i) * factors[i];
        return sum;
    }
};

/// Order 0: the irradiance of the surface, as uniform light from above. It is exact if hits have the weight
/// ShWeight::flux, which for this order is the one that fits best in the cosine-weighted sense.
template <>
struct HemisphereFit<0> {
    static constexpr int order = 0;
    using Numbers = std::array<float, 3>;
    static constexpr std::size_t light_numbers = 3;
    static constexpr std::string_view formula = "E(n) = own (1 + n.N) / 2";

    [[nodiscard]] static std::string number_name(std::size_t i) { return rgb_name("own", i); }

    struct Question {
        explicit Question(const common::Vec3& shading_normal) : normal(shading_normal) {}
        common::Vec3 normal;
    };

    [[nodiscard]] static Numbers numbers_of(const TexelLight<0>& light, const common::Vec3&) {
        // A hit of F / a has added c0 F / a, and the light's coefficient is pi times the sum.
        const common::Rgb own = light[0] / (cosine_factors<0>[0] * sh_constants::c0);
        return {own.x, own.y, own.z};
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        return rgb_at(numbers, 0) * ((1 + face_normal.dot(question.normal)) / 2);
    }
};

static_assert(Basis<HemisphereFit<0>> && Basis<HemisphereFit<1>> && Basis<HemisphereFit<2>>);

}  // namespace shlm
