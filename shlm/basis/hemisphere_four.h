// H4: four coefficients per channel, fitted to order 2 over the side from which the surface can be seen.
#pragma once

#include "shlm/basis/basis.h"
#include "shlm/basis/quadratic_light.h"

namespace shlm {

/// Order 1 wastes accuracy on normals that point into the surface. The same four functions, fitted on the
/// hemisphere alone, have half the error (Habel and Wimmer 2010).
struct HemisphereFour {
    static constexpr int order = 2;
    using Numbers =
        std::array<float, 12>;  ///< constant, then for x, y and z of the normal; three channels each
    static constexpr std::size_t light_numbers = 12;
    static constexpr std::string_view formula = "E(n) = constant + x n.x + y n.y + z n.z";

    [[nodiscard]] static std::string number_name(std::size_t i) {
        constexpr std::array<const char*, 4> layers = {"constant", "x", "y", "z"};
        return rgb_name(layers[i / 3], i % 3);
    }

    struct Question {
        explicit Question(const common::Vec3& shading_normal) : normal(shading_normal) {}
        common::Vec3 normal;
    };

    [[nodiscard]] static Numbers numbers_of(const TexelLight<2>& light, const common::Vec3& face_normal) {
        Numbers numbers;
        for (int c = 0; c < 3; ++c) {
            const QuadraticLight fit = hemisphere_fit(quadratic_light(channel_of(light, c)), face_normal);
            const auto channel = static_cast<std::size_t>(c);
            numbers[channel] = fit.constant;
            for (int i = 0; i < 3; ++i)
                numbers[3 * static_cast<std::size_t>(i + 1) + channel] = fit.linear[i];
        }
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3&,
                                                const Question& question) {
        return rgb_at(numbers, 0) + rgb_at(numbers, 3) * question.normal.x +
               rgb_at(numbers, 6) * question.normal.y + rgb_at(numbers, 9) * question.normal.z;
    }
};

static_assert(Basis<HemisphereFour>);

}  // namespace shlm
