// AD: uniform light from above and one distant light.
#pragma once

#include "shlm/basis/basis.h"
#include "shlm/basis/light_channels.h"

namespace shlm {

/// Six numbers: the colour at the texel's own normal, and the distant light's direction and share. Exact for
/// one light, for uniform light from above, and for both together if they have one colour.
///
/// Order 1 contains the integral S of the radiance and the integral V of radiance times direction. An
/// irradiance of A from the hemisphere above the normal N has S = 2 A and V = A N. A distant light of
/// irradiance D, on a plane that faces it, in direction d has S = D and V = D d. So |V - A N| = S - 2 A,
///
///     3 A^2 + (2 V.N - 4 S) A + S^2 - |V|^2 = 0,
///
/// whose smaller root has 0 <= A <= S / 2 for all possible light (|V| <= S), and D d = V - A N. The surface's
/// own irradiance, V.N, is preserved.
struct AmbientAndDirection {
    static constexpr int order = 1;
    /// Irradiance for the face's own normal; D d relative to its mean over the channels, whose rest is
    /// ambient.
    using Numbers = std::array<float, 6>;
    static constexpr std::size_t light_numbers = 3;
    static constexpr std::string_view formula =
        "E(n) = own ((1 - d.N) (1 + n.N) / 2 + max(d.n, 0)), d = direction";

    [[nodiscard]] static std::string number_name(std::size_t i) {
        return i < 3 ? rgb_name("own", i) : std::string("direction.") + "XYZ"[i - 3];
    }

    struct Question {
        explicit Question(const common::Vec3& shading_normal) : normal(shading_normal) {}
        common::Vec3 normal;
    };

    [[nodiscard]] static Numbers numbers_of(const TexelLight<1>& light, const common::Vec3& face_normal) {
        Numbers numbers{};
        for (int c = 0; c < 3; ++c)
            numbers[static_cast<std::size_t>(c)] =
                std::max(vector_of(channel_of(light, c)).dot(face_normal), 0.0f);
        const auto grey = grey_of(light);
        const common::Vec3 v = vector_of(grey);
        const float s = integral_of(grey), own = v.dot(face_normal);
        if (own <= 0) return numbers;  // lit only from below: there are no shares
        const float half = 2 * s - own;
        const float root = std::sqrt(std::max(half * half - 3 * (s * s - v.dot(v)), 0.0f));
        const float ambient = std::clamp((half - root) / 3, 0.0f, own);
        set_rgb(numbers, 3, (v - face_normal * ambient) / own);
        return numbers;
    }

    [[nodiscard]] static common::Rgb irradiance(const Numbers& numbers, const common::Vec3& face_normal,
                                                const Question& question) {
        const common::Vec3 direct = rgb_at(numbers, 3);
        const float ambient = 1 - direct.dot(face_normal);
        return rgb_at(numbers, 0) * (ambient * (1 + question.normal.dot(face_normal)) / 2 +
                                     std::max(direct.dot(question.normal), 0.0f));
    }

  private:
    /// Irradiance is S / 4 + V.n / 2 up to order 1: pi y0^2 and (2 pi / 3) (3 / (4 pi)) of radiance.
    static float integral_of(const std::array<float, 4>& e) { return 4 * sh_constants::c0 * e[0]; }
    static common::Vec3 vector_of(const std::array<float, 4>& e) {
        return common::Vec3(e[3], e[1], e[2]) * (2 * sh_constants::c1);
    }
};

static_assert(Basis<AmbientAndDirection>);

}  // namespace shlm
