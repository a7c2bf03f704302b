// The harmonics themselves: a texel keeps what it sums (Good and Taylor 2005, order 2).
#pragma once

#include "shlm/basis/basis.h"

namespace shlm {

template <int Order>
struct Harmonics {
    static constexpr int order = Order;
    using Numbers = std::array<float, 3 * harmonic_count(Order)>;  ///< channel c of harmonic i at [3 i + c]
    static constexpr std::size_t light_numbers = 3 * harmonic_count(Order);
    static constexpr std::string_view formula =
        "E(n) = sum over i of sh.i Y_i(n); Y are the orthonormal real spherical harmonics of bands 0, 1, 2 "
        "and "
        "4, m from -l to l, without the Condon-Shortley sign";

    [[nodiscard]] static std::string number_name(std::size_t i) {
        return rgb_name("sh." + std::to_string(i / 3), i % 3);
    }

    struct Question {
        explicit Question(const common::Vec3& shading_normal) : y(evaluate_sh<Order>(shading_normal)) {}
        ShValues<Order> y;
    };

    [[nodiscard]] static Numbers numbers_of(const TexelLight<Order>& light, const common::Vec3&) {
        Numbers numbers;
        for (std::size_t i = 0; i < light.size(); ++i) set_rgb(numbers, 3 * i, light[i]);
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3&,
                                                const Question& question) {
        common::Rgb sum(0, 0, 0);
        for (std::size_t i = 0; i < question.y.size(); ++i) sum += rgb_at(numbers, 3 * i) * question.y[i];
        return sum;
    }
};

static_assert(Basis<Harmonics<0>> && Basis<Harmonics<4>>);

}  // namespace shlm
