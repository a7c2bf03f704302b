// Tests each basis against its definition, and half floats against floats.
#include <gtest/gtest.h>

#include <random>

#include "bench/experiments/bases/basis.h"
#include "bench/experiments/bases/basis_error.h"
#include "bench/experiments/bases/directions.h"
#include "shlm/basis/ambient_and_direction.h"

namespace {

using namespace bench::bases;
using common::Rgb;
using common::Vec3;
using shlm::Harmonics;
using shlm::TexelLight;
using shlm::TexelModel;

constexpr unsigned seed = 1;

/// Returns any series of order 2; it need not belong to actual light.
TexelLight<2> any_light(std::mt19937& engine) {
    std::normal_distribution<float> normal;
    TexelLight<2> light;
    for (Rgb& coefficient : light) coefficient = {normal(engine), normal(engine), normal(engine)};
    return light;
}

Vec3 any_direction(std::mt19937& engine) {
    std::normal_distribution<float> normal;
    return Vec3(normal(engine), normal(engine), normal(engine)).normalized();
}

template <class Basis>
Rgb irradiance(const typename Basis::Numbers& numbers, const Vec3& face_normal, const Vec3& normal) {
    return Basis::irradiance(numbers, face_normal, typename Basis::Question(normal));
}

/// Tests one light, uniform light from above, and both together.
TEST(AmbientAndDirection, IsExactForOneLightAndUniformLight) {
    const OneTexel texel;
    const std::vector<Vec3> normals = tilted_normals();
    for (const double degrees : {0.0, 30.0, 60.0, 80.0})
        for (const double share : {0.0, 0.3, 1.0}) {
            Environment light = make_environment(LightKind::uniform, 0, 1, 1);
            for (Arrival& arrival : light) arrival.irradiance *= 1 - share;
            const double angle = degrees * std::numbers::pi / 180;
            const Vec3 towards(static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle)));
            light.push_back({towards, 10 * share * towards.z});
            const std::vector<double> truth = true_irradiance(light, normals);
            const auto answers =
                ask<TexelModel<1, shlm::ShWeight::radiance>, shlm::AmbientAndDirection, float>(
                    texel, texel.photons_of(light), normals);
            // Uniform light of so many photons is accurate to a thousandth.
            EXPECT_LE(relative_rms_percent(answers.answered, truth), share == 1 ? 0.01 : 0.1)
                << degrees << " degrees, share " << share;
        }
}

/// Every light has a finite model.
TEST(AmbientAndDirection, IsFiniteForAnyLight) {
    std::mt19937 engine(seed);
    for (int i = 0; i < 1000; ++i) {
        const TexelLight<2> any = any_light(engine);
        TexelLight<1> light;
        std::copy_n(any.begin(), light.size(), light.begin());
        const Vec3 face_normal = any_direction(engine);
        const auto numbers = shlm::AmbientAndDirection::numbers_of(light, face_normal);
        for (const float number : numbers) EXPECT_TRUE(std::isfinite(number));
        for (int c = 0; c < 3; ++c) EXPECT_GE(numbers[static_cast<std::size_t>(c)], 0);
    }
}

// Half floats.

shlm::Texel<Harmonics<0>> texel_of(float value) {
    return {{{0, 0, 1}, 1}, {value, value / 3, 0}};
}

TEST(Halves, AreWithinTheirRoundingWhateverTheLightsUnit) {
    for (const float unit : {1e-25f, 1e-6f, 1.0f, 1e6f, 1e30f}) {
        std::vector<shlm::Texel<Harmonics<0>>> texels;
        for (int exponent = 0; exponent < 26; ++exponent)
            texels.push_back(texel_of(unit * std::ldexp(1.7f, -exponent)));
        const float in_unit = shlm::unit_for_halves<Harmonics<0>>(texels);
        for (const auto& texel : texels) {
            const auto numbers = shlm::in_halves(texel, in_unit, 1).numbers();
            for (std::size_t i = 0; i < numbers.size(); ++i)
                EXPECT_NEAR(numbers[i] * in_unit, texel.stored[i], std::ldexp(texel.stored[i], -11));
        }
    }
}

TEST(Halves, OfADarkMapAreDark) {
    const std::vector<shlm::Texel<Harmonics<0>>> texels(3, texel_of(0));
    const float unit = shlm::unit_for_halves<Harmonics<0>>(texels);
    EXPECT_EQ(unit, 1);
    EXPECT_EQ(shlm::in_halves(texels[0], unit, 1).irradiance({0, 0, 1}), Rgb(0, 0, 0));
}

TEST(Halves, HalveTheNumbersBytesOfAMap) {
    const OneTexel texel;
    shlm::Sink<shlm::PaperModel> sink(texel.prepared(), shlm::OwnTexel{}, shlm::Quantum({1, 1, 1}));
    const auto floats = sink.finish(1);
    const auto halves = sink.finish<Harmonics<2>, shlm::half>(1, shlm::OwnTexel{}, 0);
    EXPECT_EQ(floats.bytes() - halves.bytes(), 27 * 2 + 10) << "and a face takes 6 bytes in place of 16";
}

TEST(PackedFace, IsWithinItsRounding) {
    const common::Vec3 normal = common::Vec3(0.3f, -0.5f, 0.2f).normalized();
    for (const float area : {1.0f, 0.5f, 0.001f}) {
        const shlm::TexelFace face = shlm::PackedFace({normal, 4 * area}, 4).unpacked();
        EXPECT_LT((face.normal - normal).length(), 1e-4f);
        EXPECT_NEAR(face.area / 0xffff, area, 0.5 / 0xffff);
    }
}

TEST(PackedFace, KnowsASliverFromNothing) {
    const common::Vec3 up(0, 0, 1);
    EXPECT_GT(shlm::PackedFace({up, 1e-12f}, 1).unpacked().area, 0);
    EXPECT_EQ(shlm::PackedFace({up, 0}, 1).unpacked().area, 0);
    EXPECT_EQ(shlm::PackedFace({{}, 0}, 0).unpacked().area, 0) << "a map without any surface";
}

}  // namespace
