// YL2: the colour at the texel's own normal, and order 2 of the channels' mean for other normals.
#pragma once

#include "shlm/basis/basis.h"
#include "shlm/basis/quadratic_light.h"

namespace shlm {

/// Eleven numbers in place of 27. As exact as order 2 if the light has one colour.
struct LuminanceNine {
    static constexpr int order = 2;
    /// Irradiance for the face's own normal, then harmonics 1 to 8 of a series that is 1 at that normal.
    using Numbers = std::array<float, 11>;
    static constexpr std::size_t light_numbers = 3;
    static constexpr std::string_view formula =
        "E(n) = own (1 + sum over i = 1 to 8 of shape.i (Y_i(n) - Y_i(N))); Y are the orthonormal real "
        "spherical "
        "harmonics of bands 1 and 2, m from -l to l, without the Condon-Shortley sign";

    [[nodiscard]] static std::string number_name(std::size_t i) {
        return i < 3 ? rgb_name("own", i) : "shape." + std::to_string(i - 2);
    }

    struct Question {
        explicit Question(const common::Vec3& shading_normal) : y(evaluate_sh<2>(shading_normal)) {}
        ShValues<2> y;
    };

    [[nodiscard]] static Numbers numbers_of(const TexelLight<2>& light, const common::Vec3& face_normal) {
        Numbers numbers{};
        const ShValues<2> y = evaluate_sh<2>(face_normal);
        const common::Rgb own = evaluate_series<2>(light, y);
        set_rgb(numbers, 0, own);
        const float grey_own = common::mean_component(own);
        if (grey_own <= 0) return numbers;  // as in AmbientAndDirection
        const auto grey = grey_of(light);
        for (std::size_t i = 1; i < grey.size(); ++i) numbers[2 + i] = grey[i] / grey_own;
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        const ShValues<2> own = evaluate_sh<2>(face_normal);
        float shape = 1;
        for (std::size_t i = 1; i < own.size(); ++i) shape += numbers[2 + i] * (question.y[i] - own[i]);
        return rgb_at(numbers, 0) * shape;
    }
};

static_assert(Basis<LuminanceNine>);

}  // namespace shlm
