#include "common/tracer/scatter.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::fresnel_reflectance;
using common::ScatteredPhoton;

constexpr std::uint64_t photon_count = count_for(400'000, 20'000);

/// Returns four uniform numbers per call, from the standard library instead of the tracer's generator.
class Uniforms {
  public:
    explicit Uniforms(std::uint64_t seed) : engine_(seed) {}
    std::array<float, 4> operator()() {
        std::array<float, 4> u;
        for (float& value : u) value = static_cast<float>(engine_() >> 40) * 0x1p-24f;
        return u;
    }

  private:
    std::mt19937_64 engine_;
};

/// A triangle that faces along `normal`, which is +z rotated by the skew rotation.
struct Plate {
    explicit Plate(const Material& material) {
        Scene flat;
        add(flat, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), material);
        scene = moved(flat, skew_rotation(), {0, 0, 0});
        normal = scene.geometric_normal[0];
    }
    /// Returns a direction of travel towards the front at this cosine of incidence, or towards the back if it
    /// is negative.
    [[nodiscard]] Vec3 arriving(double cosine) const {
        return common::Frame(normal).to_world(common::direction_at(static_cast<float>(-cosine), 0.3f));
    }
    [[nodiscard]] std::optional<ScatteredPhoton> scatter(const Vec3& direction, const Rgb& flux,
                                                         const std::array<float, 4>& u) const {
        return common::scatter(scene, {0, 0.2f, 0.3f}, direction, flux, u);
    }

    Scene scene;
    Vec3 normal;
};

void expect_near(const Vec3& a, const Vec3& b, float tolerance) {
    EXPECT_LT((a - b).length(), tolerance) << a << b;
}

TEST(Fresnel, NormalIncidence) {
    for (const float n : {1.0f, 1.33f, 1.5f, 2.4f}) {
        const float expected = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
        EXPECT_NEAR(fresnel_reflectance(1, 1 / n), expected, 1e-6f);
        EXPECT_NEAR(fresnel_reflectance(1, n), expected, 1e-6f);
    }
}

TEST(Fresnel, ParallelPartVanishesAtBrewstersAngle) {
    // At Brewster's angle, tan = n, reflectance is half the perpendicular part ((n^2 - 1) / (n^2 + 1))^2.
    for (const double n : {1.33, 1.5, 2.4}) {
        const double cosine = 1 / std::hypot(1, n);
        const double perpendicular = std::pow((n * n - 1) / (n * n + 1), 2);
        EXPECT_NEAR(fresnel_reflectance(static_cast<float>(cosine), static_cast<float>(1 / n)),
                    0.5 * perpendicular, 1e-6);
    }
}

TEST(Fresnel, ReflectsTotallyBeyondTheCriticalAngle) {
    const double n = 1.5, critical = std::sqrt(1 - 1 / (n * n));
    EXPECT_EQ(fresnel_reflectance(static_cast<float>(critical - 1e-3), 1.5f), 1);
    EXPECT_LT(fresnel_reflectance(static_cast<float>(critical + 1e-3), 1.5f), 1);
    EXPECT_NEAR(fresnel_reflectance(1e-6f, 1 / 1.5f), 1, 1e-4) << "grazing";
}

TEST(Fresnel, IsTheSameBothWays) {
    for (float cosine = 0.05f; cosine < 1; cosine += 0.05f) {
        const float inside = std::sqrt(1 - (1 - cosine * cosine) / 2.25f);
        EXPECT_NEAR(fresnel_reflectance(cosine, 1 / 1.5f), fresnel_reflectance(inside, 1.5f), 2e-6f)
            << cosine;
    }
}

TEST(Refract, FollowsSnell) {
    const Vec3 normal = Vec3(1, 2, 3).normalized();
    const common::Frame frame(normal);
    for (const float eta : {1 / 1.5f, 1.0f, 1.5f})
        for (float sine = 0; sine < 0.66f; sine += 0.05f) {
            const Vec3 direction = frame.tangent * sine - normal * std::sqrt(1 - sine * sine);
            const auto refracted = common::refract(direction, normal, eta);
            ASSERT_TRUE(refracted);
            EXPECT_NEAR(refracted->length(), 1, 1e-6);
            EXPECT_NEAR(refracted->dot(frame.tangent), eta * sine, 1e-6) << "sine times index stays";
            EXPECT_NEAR(refracted->dot(frame.bitangent), 0, 1e-6) << "stays in the plane of incidence";
            EXPECT_LT(refracted->dot(normal), 0);
            const auto back = common::refract(-*refracted, -normal, 1 / eta);
            ASSERT_TRUE(back);
            expect_near(*back, -direction, 2e-6f);
        }
    EXPECT_FALSE(common::refract(frame.tangent * 0.7f - normal * std::sqrt(1 - 0.49f), normal, 1.5f));
}

TEST(Reflect, KeepsTheAngle) {
    const Vec3 normal = Vec3(1, 2, 3).normalized(), direction = Vec3(-3, 0.5f, -1).normalized();
    const Vec3 reflected = common::reflect(direction, normal);
    EXPECT_NEAR(reflected.dot(normal), -direction.dot(normal), 1e-6);
    EXPECT_NEAR(reflected.length(), 1, 1e-6);
    expect_near(reflected - direction, normal * (reflected - direction).dot(normal), 1e-6f);
    expect_near(reflected, common::reflect(direction, -normal), 1e-6f);
}

TEST(Scatter, RouletteKeepsTheMeanOfEveryChannel) {
    constexpr std::uint64_t seed = 1;
    Uniforms uniforms(seed);
    for (const Rgb& albedo : {Rgb(0.5f, 0.5f, 0.5f), Rgb(0.9f, 0.5f, 0.1f), Rgb(0, 0.3f, 0)})
        for (const Rgb& flux : {Rgb(1, 1, 1), Rgb(0.1f, 2, 7)}) {
            const Plate plate(diffuse(albedo));
            std::array<Sample, 3> kept;
            for (std::uint64_t i = 0; i < photon_count / 4; ++i) {
                const auto next = plate.scatter(plate.arriving(0.5), flux, uniforms());
                const Rgb left = next ? next->flux : Rgb(0, 0, 0);
                ASSERT_LE(common::max_component(left), common::max_component(flux) * (1 + 1e-6f)) << "grew";
                for (int c = 0; c < 3; ++c) kept[static_cast<std::size_t>(c)].add(left[c]);
            }
            for (int c = 0; c < 3; ++c) {
                const Sample& sample = kept[static_cast<std::size_t>(c)];
                EXPECT_NEAR(sample.mean(), flux[c] * albedo[c], z_for(5e-6) * sample.standard_error() + 1e-6)
                    << "albedo " << albedo << ", flux " << flux << ", channel " << c << ", seed " << seed;
            }
        }
}

TEST(Scatter, BlackAbsorbsAllAndWhiteNothing) {
    Uniforms uniforms(2);
    const Plate black(diffuse(Rgb(0, 0, 0))), white(diffuse(Rgb(1, 1, 1)));
    for (int i = 0; i < 1000; ++i) {
        const auto u = uniforms();
        EXPECT_FALSE(black.scatter(black.arriving(0.5), Rgb(1, 1, 1), u));
        EXPECT_TRUE(white.scatter(white.arriving(0.5), Rgb(1, 2, 3), u));
    }
    EXPECT_FALSE(black.scatter(black.arriving(0.5), Rgb(1, 1, 1), {0, 0, 0, 0}));
    EXPECT_TRUE(white.scatter(white.arriving(0.5), Rgb(1, 1, 1), {0x1.fffffep-1f, 0, 0, 0}));
    EXPECT_FALSE(white.scatter(white.arriving(0.5), Rgb(0, 0, 0), {0, 0, 0, 0})) << "no photon without flux";
}

TEST(Scatter, DiffuseFollowsTheCosineLawOnBothFaces) {
    constexpr std::uint64_t seed = 3;
    Uniforms uniforms(seed);
    const Plate plate(diffuse(Rgb(1, 1, 1)));
    for (const double side : {1.0, -1.0}) {
        const common::Frame frame(plate.normal * static_cast<float>(side));
        constexpr std::size_t bins = 17;
        std::array<std::uint64_t, bins> cosine_sq{}, azimuth{};
        Sample cosine;
        for (std::uint64_t i = 0; i < photon_count; ++i) {
            const auto next = plate.scatter(plate.arriving(side * 0.7), Rgb(1, 1, 1), uniforms());
            ASSERT_TRUE(next);
            EXPECT_EQ(next->normal, frame.normal);
            const double c = next->direction.dot(frame.normal);
            ASSERT_GT(c, 0);
            cosine.add(c);
            ++cosine_sq[std::min<std::size_t>(static_cast<std::size_t>(c * c * bins), bins - 1)];
            const double angle =
                std::atan2(next->direction.dot(frame.bitangent), next->direction.dot(frame.tangent));
            ++azimuth[std::min<std::size_t>(static_cast<std::size_t>((angle + pi) / (2 * pi) * bins),
                                            bins - 1)];
        }
        const std::vector<double> expected(bins, static_cast<double>(photon_count) / bins);
        EXPECT_GT(chi_square_tail(chi_square(cosine_sq, expected), bins - 1), 1e-5) << "seed " << seed;
        EXPECT_GT(chi_square_tail(chi_square(azimuth, expected), bins - 1), 1e-5) << "seed " << seed;
        EXPECT_NEAR(cosine.mean(), 2.0 / 3, z_for(1e-5) * cosine.standard_error()) << "seed " << seed;
    }
}

TEST(Scatter, DiffuseIgnoresShadingNormals) {
    const Plate flat(diffuse(Rgb(1, 1, 1)));
    Plate bent(diffuse(Rgb(1, 1, 1)));
    for (Vec3& normal : bent.scene.normal) normal = (normal + Vec3(0.5f, 0.2f, 0)).normalized();
    const std::array<float, 4> u = {0.1f, 0.4f, 0.6f, 0.2f};
    EXPECT_EQ(flat.scatter(flat.arriving(0.5), Rgb(1, 1, 1), u)->direction,
              bent.scatter(bent.arriving(0.5), Rgb(1, 1, 1), u)->direction);
}

TEST(Scatter, MirrorsReflectOnBothFaces) {
    Uniforms uniforms(4);
    const Plate plate(mirror());
    for (const double cosine : {1.0, 0.5, 0.01, -0.01, -0.5, -1.0}) {
        const Vec3 direction = plate.arriving(cosine);
        const auto next = plate.scatter(direction, Rgb(1, 1, 1), uniforms());
        ASSERT_TRUE(next);
        expect_near(next->direction, common::reflect(direction, plate.normal), 1e-6f);
        EXPECT_GT(next->direction.dot(next->normal), 0);
    }
}

TEST(Scatter, SmoothMirrorsNeverSendAPhotonThrough) {
    Uniforms uniforms(5);
    Plate plate(mirror());
    for (Vec3& normal : plate.scene.normal)
        normal = (normal + common::Frame(normal).tangent * 2.0f).normalized();
    for (int i = 0; i < 10'000; ++i) {
        const auto u = uniforms();
        const Vec3 direction =
            common::Frame(plate.normal * (i % 2 ? 1.0f : -1.0f)).to_world(common::direction_at(-u[1], u[2]));
        if (std::abs(direction.dot(plate.normal)) < 1e-4f) continue;
        const auto next = plate.scatter(direction, Rgb(1, 1, 1), u);
        ASSERT_TRUE(next);
        EXPECT_GT(next->direction.dot(next->normal), 0);
        EXPECT_LT(direction.dot(next->normal), 0) << "left on the other side";
    }
}

TEST(Scatter, GlassSplitsAsFresnelSays) {
    constexpr std::uint64_t seed = 6;
    Uniforms uniforms(seed);
    const Plate plate(glass(1.5f));
    for (const double cosine : {1.0, 0.7, 0.3, 0.05, -1.0, -0.9, -0.76, -0.5}) {
        const Vec3 direction = plate.arriving(cosine);
        const float eta = cosine > 0 ? 1 / 1.5f : 1.5f;
        const double reflectance = fresnel_reflectance(static_cast<float>(std::abs(cosine)), eta);
        std::uint64_t reflected = 0;
        for (std::uint64_t i = 0; i < photon_count / 4; ++i) {
            const auto next = plate.scatter(direction, Rgb(1, 2, 3), uniforms());
            ASSERT_TRUE(next) << "clear glass absorbs nothing";
            EXPECT_EQ(next->flux, Rgb(1, 2, 3));
            EXPECT_GT(next->direction.dot(next->normal), 0);
            const bool back = next->direction.dot(plate.normal) * direction.dot(plate.normal) < 0;
            reflected += back;
            const Vec3 incident_side = plate.normal * (cosine > 0 ? 1.0f : -1.0f);
            const Vec3 expected = back ? common::reflect(direction, incident_side)
                                       : *common::refract(direction, incident_side, eta);
            ASSERT_LT((next->direction - expected).length(), 1e-5f);
        }
        const double count = static_cast<double>(photon_count / 4);
        const double error = std::sqrt(reflectance * (1 - reflectance) / count);
        EXPECT_NEAR(static_cast<double>(reflected) / count, reflectance, z_for(1e-5) * error)
            << "cosine " << cosine << ", seed " << seed;
    }
}

}  // namespace
