#include "common/tracer/photon_source.h"

#include <gtest/gtest.h>

#include "common/core/input_error.h"
#include "tests/support/see_through.h"
#include "tests/support/statistics.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::EmittedPhoton;
using common::PhotonSource;

constexpr std::uint64_t photon_count = count_for(400'000, 20'000);

void expect_near(const Rgb& actual, const Rgb& expected, double relative) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], relative * expected[c]) << "channel " << c;
}

Scene lamp(const Material& material) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), material);
    return scene;
}

/// Makes a box that gives the scene bounds of a known size: diagonal 2 sqrt(3).
Scene dark_box() {
    return closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
}

/// Returns the spot's intensity by the formula of KHR_lights_punctual.
double gltf_falloff(double cosine, double cos_inner, double cos_outer) {
    const double scale = 1 / std::max(0.001, cos_inner - cos_outer);
    const double ramp = std::clamp(cosine * scale - cos_outer * scale, 0.0, 1.0);
    return ramp * ramp;
}

/// Returns the integral of the falloff over the directions with cosines from `low` to `high`.
double spot_integral(double cos_inner, double cos_outer, double low, double high) {
    constexpr int steps = 100'000;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        sum += gltf_falloff(low + (high - low) * (i + 0.5) / steps, cos_inner, cos_outer);
    return 2 * pi * (high - low) / steps * sum;
}

const common::SpotLight spot{{0, 0, 0}, Vec3(1, 2, -2).normalized(), Rgb(3, 2, 1), 0.95f, 0.8f};

TEST(PhotonSource, HasThePowerOfAnAreaLight) {
    const Material one_sided = diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3));
    const auto area = static_cast<float>(6 * pi);
    expect_near(PhotonSource(lamp(one_sided)).power(), Rgb(1, 2, 3) * area, 1e-6);
    expect_near(PhotonSource(lamp(double_sided(one_sided))).power(), Rgb(1, 2, 3) * (2 * area), 1e-6);
}

TEST(PhotonSource, HasThePowerOfAPointLight) {
    Scene scene;
    scene.point_light.push_back({{0, 0, 0}, Rgb(1, 2, 3)});
    expect_near(PhotonSource(scene).power(), Rgb(1, 2, 3) * static_cast<float>(4 * pi), 1e-6);
}

TEST(PhotonSource, HasThePowerOfASpotLight) {
    Scene scene;
    scene.spot_light.push_back(spot);
    const double integral = spot_integral(spot.cos_inner_angle, spot.cos_outer_angle, -1, 1);
    expect_near(PhotonSource(scene).power(), spot.intensity * static_cast<float>(integral), 1e-5);
}

TEST(PhotonSource, HasThePowerThatEntersTheBoundingBox) {
    Scene sunny = dark_box();
    sunny.directional_light.push_back({{0, -1, 0}, Rgb(1, 2, 3)});
    expect_near(PhotonSource(sunny).power(), Rgb(1, 2, 3) * 4.0f, 1e-6);
    sunny.directional_light[0].direction = Vec3(1, -1, 0).normalized();
    expect_near(PhotonSource(sunny).power(), Rgb(1, 2, 3) * static_cast<float>(4 * std::numbers::sqrt2),
                1e-6);
    Scene cloudy = dark_box();
    cloudy.sky = common::Sky{Rgb(1, 2, 3)};
    expect_near(PhotonSource(cloudy).power(), Rgb(1, 2, 3) * static_cast<float>(24 * pi), 1e-6);
}

/// Makes an empty plain.
Scene plain() {
    Scene scene;
    add(scene, quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}), diffuse(Rgb(0, 0, 0)));
    return scene;
}

TEST(PhotonSource, SunAndSkyOverAPlainMissNothing) {
    constexpr std::uint64_t photons = count_for(20'000, 4'000);
    Scene sunny = plain();
    sunny.directional_light.push_back({Vec3(1, -1, 0.5f).normalized(), Rgb(1, 1, 1)});
    EXPECT_EQ(record(sunny, 1, {.photons = photons}).report.fates.missed, 0u);
    Scene cloudy = plain();
    cloudy.sky = common::Sky{Rgb(1, 1, 1)};
    EXPECT_EQ(record(cloudy, 1, {.photons = photons}).report.fates.missed, 0u);
}

TEST(PhotonSource, LightFromAfarGoesTowardsTheScene) {
    constexpr std::uint64_t seed = 11;
    Scene scene;
    add(scene, quad({-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}), diffuse(Rgb(0, 0, 0)));
    scene.point_light.push_back({{0, 1000, 0}, Rgb(1e6f, 2e6f, 0)});
    const TracedRun run = record(scene, seed, {.photons = photon_count});
    // The plate covers 2 / pi of the disc that its bounding sphere covers from there.
    const auto hits = static_cast<double>(run.hits.size());
    EXPECT_NEAR(hits / static_cast<double>(photon_count), 2 / pi,
                z_for(1e-5) * std::sqrt(0.24 / static_cast<double>(photon_count)) + 5e-3)
        << "seed " << seed;
    double flux = 0;
    for (const Rgb& f : run.hits.flux) flux += f.y * run.report.watts_per_flux();
    EXPECT_NEAR(flux, 2, 2 * z_for(1e-5) / std::sqrt(hits) + 1e-5) << "irradiance 2 on an area of 1";
}

TEST(PhotonSource, AddsUpAllLights) {
    Scene scene = lamp(diffuse(Rgb(0, 0, 0), Rgb(1, 0, 0)));
    scene.point_light.push_back({{0, 0, 0}, Rgb(0, 1, 0)});
    scene.point_light.push_back({{0, 1, 0}, Rgb(0, 2, 0)});
    EXPECT_NEAR(PhotonSource(scene).power().x, 6 * pi, 1e-4);
    EXPECT_NEAR(PhotonSource(scene).power().y, 12 * pi, 1e-4);
    EXPECT_EQ(PhotonSource(scene).power().z, 0);
}

TEST(PhotonSource, ThrowsWithoutLight) {
    EXPECT_THROW(PhotonSource{dark_box()}, common::InputError);
    Scene unlit = dark_box();
    unlit.point_light.push_back({{0, 0, 0}, Rgb(0, 0, 0)});
    EXPECT_THROW(PhotonSource{unlit}, common::InputError) << "a light switched off";
}

TEST(PhotonSource, ChoosesLightsInProportionToTheirPower) {
    constexpr std::uint64_t seed = 1;
    const std::vector<Rgb> intensity = {
        {1, 1, 1}, {6, 0, 0}, {0, 0, 9}, {4, 4, 4}, {5, 5, 5}};  // means 1 to 5
    Scene scene;
    for (std::size_t i = 0; i < intensity.size(); ++i)
        scene.point_light.push_back({{static_cast<float>(i), 0, 0}, intensity[i]});
    const PhotonSource source(scene);
    std::array<std::uint64_t, 5> counts{};
    for (std::uint64_t i = 0; i < photon_count; ++i)
        ++counts[static_cast<std::size_t>(std::lround(source.emit(seed, i).origin.x))];
    std::array<double, 5> expected;
    for (std::size_t i = 0; i < 5; ++i)
        expected[i] = static_cast<double>(photon_count) * static_cast<double>(i + 1) / 15;
    EXPECT_GT(chi_square_tail(chi_square(counts, expected), 4), 1e-4) << "seed " << seed;
}

/// Expects the mean flux of emitted photons to be the source's power, in every channel.
void expect_mean_flux_is_power(const Scene& scene, const char* what) {
    constexpr std::uint64_t seed = 2;
    const PhotonSource source(scene);
    std::array<Sample, 3> flux;
    for (std::uint64_t i = 0; i < photon_count; ++i) {
        const EmittedPhoton photon = source.emit(seed, i);
        for (int c = 0; c < 3; ++c) flux[static_cast<std::size_t>(c)].add(photon.flux[c]);
    }
    for (int c = 0; c < 3; ++c) {
        const Sample& sample = flux[static_cast<std::size_t>(c)];
        const double power = source.power()[c];
        EXPECT_NEAR(sample.mean(), power, z_for(1e-5) * sample.standard_error() + 1e-5 * power)
            << what << ", channel " << c << ", seed " << seed;
    }
}

TEST(PhotonSource, EmitsItsPowerOnAverage) {
    expect_mean_flux_is_power(lamp(diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3))), "area");
    expect_mean_flux_is_power(lamp(double_sided(diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3)))), "both faces");
    Scene point;
    point.point_light.push_back({{0, 0, 0}, Rgb(1, 2, 3)});
    expect_mean_flux_is_power(point, "point");
    Scene spotted;
    spotted.spot_light.push_back(spot);
    expect_mean_flux_is_power(spotted, "spot");
    Scene sunny = dark_box();
    sunny.directional_light.push_back({{0, -1, 0}, Rgb(1, 2, 3)});
    expect_mean_flux_is_power(sunny, "directional");
    Scene cloudy = dark_box();
    cloudy.sky = common::Sky{Rgb(1, 2, 3)};
    expect_mean_flux_is_power(cloudy, "sky");
    Scene all = moved(lamp(diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3))), skew_rotation(), {1, 2, 3});
    all.point_light.push_back({{0, 0, 0}, Rgb(3, 2, 0)});
    all.spot_light.push_back(spot);
    all.directional_light.push_back({{0, -1, 0}, Rgb(0, 0.1f, 0.2f)});
    all.sky = common::Sky{Rgb(0.1f, 0.2f, 0.1f)};
    expect_mean_flux_is_power(all, "all kinds");
}

TEST(PhotonSource, EmitsTheMeanOfAnEmissiveTexture) {
    constexpr std::uint64_t seed = 3;
    // Left half black, right half white, all in full-sized steps: the mean of the bilinear texture is 1/2.
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 64; ++i) pixels.insert(pixels.end(), 3, i < 32 ? 0 : 255);
    Material material = diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3));
    material.emissive_texture = {0, 1};
    Scene scene = lamp(material);
    scene.texture.emplace_back("half", 64, 1, pixels, common::ColorSpace::srgb, common::Wrap::clamp_to_edge,
                               common::Wrap::clamp_to_edge);
    const PhotonSource source(scene);
    Sample flux, from_the_left;
    for (std::uint64_t i = 0; i < photon_count; ++i) {
        const EmittedPhoton photon = source.emit(seed, i);
        flux.add(photon.flux.z);
        from_the_left.add(photon.origin.x < 0.9f ? photon.flux.z : 0);
    }
    EXPECT_NEAR(flux.mean(), 9 * pi, z_for(1e-5) * flux.standard_error()) << "seed " << seed;
    EXPECT_EQ(from_the_left.mean(), 0) << "the dark half";
}

TEST(PhotonSource, HolesEmitNothing) {
    constexpr std::uint64_t seed = 5;
    const Material light = diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3));
    const Scene half = lamp(blended(light, 0.5f));
    expect_near(PhotonSource(half).power(), Rgb(1, 2, 3) * static_cast<float>(3 * pi), 1e-6);
    expect_mean_flux_is_power(half, "there in part");
    EXPECT_THROW(PhotonSource{lamp(masked(light, 0.4f))}, common::InputError) << "a lamp that is not there";

    Scene fence;
    add(fence, quad({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), masked(checkered(fence, light)));
    const PhotonSource source(fence);
    Sample flux, dark;
    for (std::uint64_t i = 0; i < photon_count; ++i) {
        const EmittedPhoton photon = source.emit(seed, i);
        flux.add(photon.flux.z);
        dark.add(photon.flux == Rgb(0, 0, 0));
    }
    EXPECT_NEAR(dark.mean(), 0.5, z_for(1e-5) * dark.standard_error()) << "half of the lamp is holes";
    EXPECT_NEAR(flux.mean(), 9 * pi, z_for(1e-5) * flux.standard_error()) << "seed " << seed;
}

TEST(PhotonSource, SpotLightsMayHaveASharpEdge) {
    Scene scene;
    common::SpotLight sharp = spot;
    sharp.cos_inner_angle = sharp.cos_outer_angle;
    scene.spot_light.push_back(sharp);
    const PhotonSource source(scene);
    const Rgb power = sharp.intensity * static_cast<float>(2 * pi * 0.2);
    expect_near(source.power(), power, 1e-6);
    for (const std::uint64_t index : {0, 1, 2, 3}) expect_near(source.emit(1, index).flux, power, 1e-6);
    // This photon draws the largest possible random number, and thus the very edge, where the falloff divides
    // 0 by 0.
    const Rgb edge = source.emit(1, 10'223'920).flux;
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(edge[c], 0);
        EXPECT_LE(edge[c], power[c] * 1.000001f);
    }
}

/// Makes a spot with a half angle of `degrees` and a ramp over the fraction `soft` of 1 - cosine.
common::SpotLight laser(double degrees, double soft) {
    const double versine = 2 * std::pow(std::sin(degrees * pi / 360), 2);
    return {{0, 0, 0}, Vec3(1, 2, -2).normalized(), Rgb(3, 2, 1), 1 - (1 - soft) * versine, 1 - versine};
}

TEST(PhotonSource, NarrowSpotsKeepTheirLight) {
    constexpr std::uint64_t seed = 12;
    for (const double degrees : {1e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 3.5})
        for (const double soft : {0.0, 1e-3, 0.5, 1.0}) {
            SCOPED_TRACE(testing::Message() << degrees << " degrees, " << soft << ", seed " << seed);
            Scene scene;
            scene.spot_light.push_back(laser(degrees, soft));
            const PhotonSource source(scene);
            const double versine = 2 * std::pow(std::sin(degrees * pi / 360), 2);
            const double power = 3 * 2 * pi * versine * (1 - soft + soft / 3);
            EXPECT_NEAR(source.power().x, power, 1e-5 * power);
            Sample flux, off_axis_sq;
            for (std::uint64_t i = 0; i < count_for(10'000, 1'000); ++i) {
                const EmittedPhoton photon = source.emit(seed, i);
                flux.add(photon.flux.x);
                off_axis_sq.add(static_cast<double>((photon.direction - scene.spot_light[0].axis).length2()));
                ASSERT_NEAR(photon.direction.length(), 1, 1e-6);
            }
            EXPECT_NEAR(flux.mean(), power, z_for(1e-6) * flux.standard_error() + 1e-5 * power);
            // Squared distances from the axis are twice 1 - cosine, which is uniform up to the edge; floats
            // perturb directions by 1e-7.
            EXPECT_NEAR(off_axis_sq.mean(), versine,
                        z_for(1e-6) * off_axis_sq.standard_error() + 2e-7 * std::sqrt(versine) + 1e-13);
        }
}

// --- emissive textures

/// Makes a texture of 64 x 64 texels, black except for `white`, and a lamp that shows it once or `repeated`
/// times.
Scene lamp_with_texels(const std::vector<std::array<int, 2>>& white, float repeated = 1,
                       common::Wrap wrap = common::Wrap::repeat) {
    std::vector<std::uint8_t> pixels(3 * 64 * 64, 0);
    for (const auto& [x, y] : white)
        for (int c = 0; c < 3; ++c) pixels[static_cast<std::size_t>(3 * (64 * y + x) + c)] = 255;
    Material material = diffuse(Rgb(0, 0, 0), Rgb(1, 2, 3));
    material.emissive_texture = {0, 0};
    Scene scene = lamp(material);
    for (Vec2& texcoord : scene.texcoord[0]) texcoord *= repeated;
    scene.texture.emplace_back("lamp", 64, 64, pixels, common::ColorSpace::srgb, wrap, wrap);
    return scene;
}

TEST(EmissiveTexture, PhotonsStartWhereItShines) {
    constexpr std::uint64_t seed = 13;
    for (const common::Wrap wrap :
         {common::Wrap::repeat, common::Wrap::mirrored_repeat, common::Wrap::clamp_to_edge})
        for (const float repeated : {1.0f, 10.0f, 0.1f}) {
            SCOPED_TRACE(testing::Message() << "repeated " << repeated << ", seed " << seed);
            const Scene scene = lamp_with_texels({{3, 2}, {4, 2}, {3, 3}, {4, 3}}, repeated, wrap);
            const PhotonSource source(scene);
            Sample flux;
            std::uint64_t dark = 0;
            for (std::uint64_t i = 0; i < photon_count; ++i) {
                const Rgb carried = source.emit(seed, i).flux;
                flux.add(carried.z);
                dark += carried == Rgb(0, 0, 0);
            }
            // Over whole periods, the mean of the bilinear texture is that of its texels. With clamping, a
            // lamp that would show ten periods shows one.
            const bool clamped = wrap == common::Wrap::clamp_to_edge && repeated > 1;
            if (repeated >= 1) {
                const double mean = 4.0 / (64 * 64) / (clamped ? repeated * repeated : 1);
                EXPECT_NEAR(flux.mean(), 18 * pi * mean,
                            z_for(1e-5) * flux.standard_error() + 1e-4 * 18 * pi * mean);
            }
            EXPECT_LT(static_cast<double>(dark), 0.2 * static_cast<double>(photon_count));
            const double relative_variance =
                std::pow(flux.standard_error() / flux.mean(), 2) * static_cast<double>(photon_count);
            EXPECT_LT(relative_variance, 1.0) << "of a single photon; uniform over the lamp it would be 1000";
        }
}

TEST(EmissiveTexture, BlackTrianglesAreNoLights) {
    const Scene scene = lamp_with_texels({{5, 50}});  // in the quad's second triangle: u < v
    EXPECT_EQ(PhotonSource(scene).emitters().size(), 1u);
    EXPECT_THROW(PhotonSource(lamp_with_texels({})), common::InputError);
}

TEST(EmissiveTexture, OneTexelOfManyIsFound) {
    constexpr std::uint64_t seed = 14;
    constexpr int size = 2048;
    std::vector<std::uint8_t> pixels(3 * size * size, 0);
    for (int c = 0; c < 3; ++c) pixels[static_cast<std::size_t>(3 * (size * 777 + 1234) + c)] = 255;
    Material material = diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1));
    material.emissive_texture = {0, 0};
    Scene scene = lamp(material);
    scene.texture.emplace_back("lamp", size, size, pixels, common::ColorSpace::srgb, common::Wrap::repeat,
                               common::Wrap::repeat);
    const PhotonSource source(scene);
    Sample flux;
    for (std::uint64_t i = 0; i < count_for(100'000, 5'000); ++i) flux.add(source.emit(seed, i).flux.x);
    const double expected = 6 * pi / (static_cast<double>(size) * size);
    EXPECT_NEAR(flux.mean(), expected, z_for(1e-5) * flux.standard_error()) << "seed " << seed;
    EXPECT_LT(flux.standard_error(), 0.02 * expected);
}

TEST(EmissiveTexture, PhotonsWithoutLightAreNoHits) {
    // Texels of one colour on a lamp of another one: their cells keep a small probability.
    std::vector<std::uint8_t> pixels = {255, 0, 0, 0, 255, 0};
    Material material = diffuse(Rgb(0, 0, 0), Rgb(1, 0, 0));
    material.emissive_texture = {0, 0};
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)), {-5, -5, -5}, {5, 5, 5});
    add(scene, quad({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), material);
    scene.texture.emplace_back("red, green", 2, 1, pixels, common::ColorSpace::linear,
                               common::Wrap::clamp_to_edge, common::Wrap::clamp_to_edge);
    scene.point_light.push_back({{1, 1, 1}, Rgb(1, 1, 1)});
    const TracedRun run = record(scene, 15, {.photons = 4096});
    EXPECT_GT(run.report.fates.without_light, 0u);
    EXPECT_EQ(run.report.fates.emitted, 4096u);
    for (const Rgb& flux : run.hits.flux) ASSERT_GT(flux.x + flux.y + flux.z, 0);
}

TEST(PhotonSource, AreaLightsFollowTheCosineLaw) {
    constexpr std::uint64_t seed = 4;
    const Scene scene = moved(lamp(diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1))), skew_rotation(), {1, 2, 3});
    const PhotonSource source(scene);
    Sample cosine, sideways_x, sideways_y;
    constexpr std::size_t bins = 33;
    std::array<std::uint64_t, bins> cosine_sq{};  // uniform in [0, 1]
    const common::Frame frame(scene.geometric_normal[0]);
    for (std::uint64_t i = 0; i < photon_count; ++i) {
        const Vec3 direction = source.emit(seed, i).direction;
        ASSERT_NEAR(direction.length(), 1, 1e-5);
        const double c = direction.dot(frame.normal);
        ASSERT_GT(c, 0);
        cosine.add(c);
        sideways_x.add(direction.dot(frame.tangent));
        sideways_y.add(direction.dot(frame.bitangent));
        ++cosine_sq[std::min<std::size_t>(static_cast<std::size_t>(c * c * bins), bins - 1)];
    }
    EXPECT_NEAR(cosine.mean(), 2.0 / 3, z_for(1e-5) * cosine.standard_error()) << "seed " << seed;
    EXPECT_NEAR(sideways_x.mean(), 0, z_for(1e-5) * sideways_x.standard_error()) << "seed " << seed;
    EXPECT_NEAR(sideways_y.mean(), 0, z_for(1e-5) * sideways_y.standard_error()) << "seed " << seed;
    const std::vector<double> expected(bins, static_cast<double>(photon_count) / bins);
    EXPECT_GT(chi_square_tail(chi_square(cosine_sq, expected), bins - 1), 1e-5) << "seed " << seed;
}

TEST(PhotonSource, AreaLightsEmitFromAllOfTheirSurface) {
    constexpr std::uint64_t seed = 5;
    const Scene scene = lamp(diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)));
    const PhotonSource source(scene);
    constexpr std::size_t cells = 5;  // 25 of equal area, so 24 degrees of freedom
    std::array<std::uint64_t, cells * cells> counts{};
    for (std::uint64_t i = 0; i < photon_count; ++i) {
        const Vec3 origin = source.emit(seed, i).origin;
        ASSERT_EQ(origin.z, 0);
        const auto x = std::min<std::size_t>(static_cast<std::size_t>(origin.x / 2 * cells), cells - 1);
        const auto y = std::min<std::size_t>(static_cast<std::size_t>(origin.y / 3 * cells), cells - 1);
        ++counts[cells * y + x];
    }
    const std::vector<double> expected(counts.size(), static_cast<double>(photon_count) / counts.size());
    EXPECT_GT(chi_square_tail(chi_square(counts, expected), counts.size() - 1), 1e-4) << "seed " << seed;
}

TEST(PhotonSource, DoubleSidedLightsEmitFromBothFaces) {
    constexpr std::uint64_t seed = 6;
    const Scene scene = lamp(double_sided(diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1))));
    const PhotonSource source(scene);
    Sample up;
    for (std::uint64_t i = 0; i < photon_count; ++i) up.add(source.emit(seed, i).direction.z > 0);
    EXPECT_NEAR(up.mean(), 0.5, z_for(1e-4) * up.standard_error()) << "seed " << seed;
}

TEST(PhotonSource, SpotLightsFallOffAsGltfSays) {
    constexpr std::uint64_t seed = 7;
    Scene scene;
    scene.spot_light.push_back(spot);
    const PhotonSource source(scene);
    constexpr std::size_t bins = 10;
    const double outer = spot.cos_outer_angle, inner = spot.cos_inner_angle;
    std::array<Sample, bins> flux;
    for (std::uint64_t i = 0; i < photon_count; ++i) {
        const EmittedPhoton photon = source.emit(seed, i);
        const double c = photon.direction.dot(spot.axis);
        ASSERT_GE(c, outer - 1e-6) << "outside its cone";
        const double place = std::clamp((c - outer) / (1 - outer) * bins, 0.0, bins - 0.5);
        for (std::size_t b = 0; b < bins; ++b)
            flux[b].add(static_cast<std::size_t>(place) == b ? photon.flux.x : 0);
    }
    for (std::size_t b = 0; b < bins; ++b) {
        const double low = outer + (1 - outer) * static_cast<double>(b) / bins,
                     high = low + (1 - outer) / bins;
        const double expected = spot.intensity.x * spot_integral(inner, outer, low, high);
        EXPECT_NEAR(flux[b].mean(), expected, z_for(1e-5) * flux[b].standard_error() + 1e-5 * expected)
            << "cosines " << low << " to " << high << ", seed " << seed;
    }
}

TEST(PhotonSource, PointLightGivesIntensityTimesCosineOverDistanceSquared) {
    constexpr std::uint64_t seed = 8;
    constexpr double height = 0.5, intensity = 2;
    Scene scene;
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), diffuse(Rgb(0, 0, 0)));
    scene.point_light.push_back({{0, 0, height}, Rgb(intensity, intensity, intensity)});
    const TracedRun run = record(scene, seed, {.photons = photon_count});
    constexpr std::size_t rings = 10;
    constexpr double width = 0.1;
    std::array<double, rings> flux{};
    std::array<std::uint64_t, rings> hits{};
    for (std::size_t i = 0; i < run.hits.size(); ++i) {
        const double r = std::hypot(run.hits.position[i].x, run.hits.position[i].y);
        if (r >= rings * width) continue;
        flux[static_cast<std::size_t>(r / width)] += run.hits.flux[i].x * run.report.watts_per_flux();
        ++hits[static_cast<std::size_t>(r / width)];
    }
    for (std::size_t ring = 0; ring < rings; ++ring) {
        // I cos / d^2, integrated over the ring, is I times the ring's solid angle: 2 pi times the difference
        // of the cosines.
        const double inner = static_cast<double>(ring) * width, outer = inner + width;
        const double expected =
            intensity * 2 * pi * (height / std::hypot(height, inner) - height / std::hypot(height, outer));
        const double relative_error = 1 / std::sqrt(static_cast<double>(hits[ring]));
        EXPECT_NEAR(flux[ring], expected, z_for(1e-5) * relative_error * expected)
            << "ring " << ring << ", seed " << seed;
    }
}

/// The flux per area on each face of a plate of area 4 at the centre of a larger scene.
struct PlateLight {
    double front, back, relative_error;
};

PlateLight light_on_plate(Scene scene, std::uint64_t seed) {
    const std::uint32_t plate = add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), diffuse(Rgb(0, 0, 0)));
    add(scene, quad({3, 3, 3}, {0.1f, 0, 0}, {0, 0.1f, 0}), diffuse(Rgb(0, 0, 0)));
    add(scene, quad({-3, -3, -3}, {0.1f, 0, 0}, {0, 0.1f, 0}), diffuse(Rgb(0, 0, 0)));
    const TracedRun run = record(scene, seed, {.photons = photon_count});
    PlateLight light{0, 0, 0};
    double hits = 0;
    for (std::size_t i = 0; i < run.hits.size(); ++i) {
        if (scene.instance_of[run.hits.surface[i].triangle] != plate) continue;
        (run.hits.direction[i].z < 0 ? light.front : light.back) +=
            run.hits.flux[i].x * run.report.watts_per_flux() / 4;
        hits += 0.5;
    }
    light.relative_error = 1 / std::sqrt(hits);
    return light;
}

TEST(PhotonSource, SkyGivesPiTimesItsRadiance) {
    constexpr std::uint64_t seed = 9;
    Scene scene;
    scene.sky = common::Sky{Rgb(2, 2, 2)};
    const PlateLight light = light_on_plate(scene, seed);
    // The small plates hide less than 2 * 0.01 / 27 of the sky's pi.
    const double bound = z_for(5e-5) * light.relative_error * 2 * pi + 1e-3 * 2 * pi;
    EXPECT_NEAR(light.front, 2 * pi, bound) << "seed " << seed;
    EXPECT_NEAR(light.back, 2 * pi, bound) << "seed " << seed;
}

TEST(PhotonSource, SunGivesItsIrradianceTimesTheCosine) {
    constexpr std::uint64_t seed = 10;
    Scene scene;
    scene.directional_light.push_back({Vec3(1, 0, -2).normalized(), Rgb(3, 3, 3)});
    const PlateLight light = light_on_plate(scene, seed);
    const double expected = 3 * 2 / std::sqrt(5.0);
    EXPECT_NEAR(light.front, expected, z_for(1e-4) * light.relative_error * expected) << "seed " << seed;
    EXPECT_EQ(light.back, 0);
}

}  // namespace
