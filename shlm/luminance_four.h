// YH4: colour at the texel's own normal, H4 of the channels' mean for the rest.
#pragma once

#include "shlm/hemisphere_four.h"

namespace shlm {

/// Six numbers in place of twelve: all channels change by the same factor as the normal tilts. Exact where
/// the light has one colour.
struct LuminanceFour {
    static constexpr int order = 2;
    using Numbers = std::array<float, 6>;  ///< irradiance of the face's own normal, change by x, y and z
    static constexpr std::size_t light_numbers = 3;

    using Question = HemisphereFour::Question;

    [[nodiscard]] static Numbers numbers_of(const TexelLight<2>& light, const common::Vec3& face_normal) {
        Numbers numbers{};
        for (int c = 0; c < 3; ++c)
            numbers[static_cast<std::size_t>(c)] = quadratic_light(channel_of(light, c)).at(face_normal);
        const QuadraticLight grey = quadratic_light(grey_of(light));
        const float own = grey.at(face_normal);
        // What no longer has light of its own has no shape either: below zero the series is all error.
        if (own <= 0) return numbers;
        const QuadraticLight fit = hemisphere_fit(grey, face_normal);
        set_rgb(numbers, 3, fit.linear / own);
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        return rgb_at(numbers, 0) * (1 + rgb_at(numbers, 3).dot(question.normal - face_normal));
    }
};

static_assert(Basis<LuminanceFour>);

}  // namespace shlm
