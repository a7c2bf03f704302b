// YF1, YF2: the hemisphere fit of the channels' mean, in the colour that the surface's own normal sees.
#pragma once

#include "shlm/basis/hemisphere_fit.h"
#include "shlm/basis/light_channels.h"

namespace shlm {

/// Six numbers for order 1 and eleven for order 2, in place of 12 and 27. As exact as HemisphereFit if the
/// light has one colour; exact for every channel at the surface's own normal.
template <int Order>
struct LuminanceFit {
    static constexpr int order = Order;
    static constexpr std::size_t light_numbers = harmonic_count(Order);
    /// The harmonics of the mean of the channels; then red and green at the own normal divided by that mean.
    using Numbers = std::array<float, light_numbers + 2>;
    static constexpr std::string_view formula =
        "E(n) = colour.c sum over i of mean.i q_i / A_i, colour.B = 3 - colour.R - colour.G; A = pi, 2 pi / "
        "3, pi / 4 for bands 0, 1, 2; q_i are the factors of the orthonormal real spherical harmonics, m "
        "from -l to l, without the Condon-Shortley sign, in the least squares fit of max(w.n, 0) over the "
        "directions w with w.N > 0";

    [[nodiscard]] static std::string number_name(std::size_t i) {
        return i < light_numbers ? "mean." + std::to_string(i) : rgb_name("colour", i - light_numbers);
    }

    using Question = typename HemisphereFit<Order>::Question;

    [[nodiscard]] static Numbers numbers_of(const TexelLight<Order>& light, const common::Vec3& normal) {
        const auto grey = grey_of(light);
        Numbers numbers;
        std::copy(grey.begin(), grey.end(), numbers.begin());
        const common::Rgb own = HemisphereFit<Order>::irradiance(
            HemisphereFit<Order>::numbers_of(light, normal), normal, Question(normal));
        const float mean = common::mean_component(own);
        // Where no light reaches the surface, there is no colour of it.
        for (std::size_t c = 0; c < 2; ++c)
            numbers[light_numbers + c] =
                mean > 0 ? std::clamp(own[static_cast<int>(c)] / mean, 0.0f, 3.0f) : 1;
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        return irradiance(numbers, fitted_factors<Order>(face_normal, question.normal));
    }

    /// As above, with the factors of the two normals.
    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const ShValues<Order>& factors) {
        float mean = 0;
        for (std::size_t i = 0; i < light_numbers; ++i) mean += numbers[i] * factors[i];
        return colour(numbers) * mean;
    }

    /// Returns what the mean of the channels is multiplied by; the mean of the colour's channels is 1.
    [[nodiscard]] static common::Rgb colour(const Numbers& numbers) {
        const float red = numbers[light_numbers], green = numbers[light_numbers + 1];
        return {red, green, std::max(3 - red - green, 0.0f)};
    }
};

static_assert(Basis<LuminanceFit<1>> && Basis<LuminanceFit<2>>);

}  // namespace shlm
