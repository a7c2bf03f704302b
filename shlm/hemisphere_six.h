// H6: H4 and the two quadratic functions that it cannot see (Habel and Wimmer 2010).
#pragma once

#include "common/core/sampling.h"
#include "shlm/hemisphere_four.h"

namespace shlm {

/// x y and x^2 - y^2 in the frame of the face are orthogonal to H4 on the hemisphere, so H4 stays as it is.
struct HemisphereSix {
    static constexpr int order = 2;
    using Numbers = std::array<float, 18>;  ///< H4's, then those of x^2 - y^2 and 2 x y
    static constexpr std::size_t light_numbers = 18;

    using Question = HemisphereFour::Question;

    [[nodiscard]] static Numbers numbers_of(const TexelLight<2>& light, const common::Vec3& face_normal) {
        Numbers numbers;
        const HemisphereFour::Numbers four = HemisphereFour::numbers_of(light, face_normal);
        std::copy(four.begin(), four.end(), numbers.begin());
        const common::Frame frame(face_normal);
        for (int c = 0; c < 3; ++c) {
            const Imath::M33f matrix = quadratic_light(channel_of(light, c)).matrix;
            const float xx = frame.tangent.dot(frame.tangent * matrix),
                        yy = frame.bitangent.dot(frame.bitangent * matrix);
            numbers[12 + static_cast<std::size_t>(c)] = (xx - yy) / 2;
            numbers[15 + static_cast<std::size_t>(c)] = frame.tangent.dot(frame.bitangent * matrix);
        }
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        HemisphereFour::Numbers four;
        std::copy_n(numbers.begin(), four.size(), four.begin());
        const common::Frame frame(face_normal);
        const float x = frame.tangent.dot(question.normal), y = frame.bitangent.dot(question.normal);
        return HemisphereFour::irradiance(four, face_normal, question) +
               rgb_at(numbers, 12) * (x * x - y * y) + rgb_at(numbers, 15) * (2 * x * y);
    }
};

static_assert(Basis<HemisphereSix>);

}  // namespace shlm
