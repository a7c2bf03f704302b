// Tests what the pilot's few photons say of each light, and how this is used.
#include "common/tracer/pilot.h"

#include <gtest/gtest.h>

#include "common/tracer/null_sink.h"
#include "common/tracer/recording_sink.h"
#include "tests/support/statistics.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::LightReach;
using common::PhotonSource;
using common::Pilot;
using common::RayScene;

Material named(Material material, const char* name) {
    material.name = name;
    return material;
}

Pilot pilot_of(const Scene& scene) {
    const RayScene rays(scene);
    return PhotonSource(rays).pilot();
}

/// Makes a grey room with a lamp under its ceiling.
Scene room_with_lamp() {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    add(scene, quad({-0.3f, 0.9f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}),
        named(diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)), "lamp"));
    return scene;
}

TEST(Pilot, FindsNothingInAClosedRoom) {
    const Pilot pilot = pilot_of(room_with_lamp());
    ASSERT_EQ(pilot.light.size(), 1u) << "two triangles of one material are one light";
    EXPECT_EQ(pilot.light[0].light, "material 'lamp'");
    EXPECT_EQ(pilot.light[0].missed, 0);
    EXPECT_EQ(pilot.light[0].on_backs, 0);
    EXPECT_EQ(pilot.endless, 0);
}

TEST(Pilot, KnowsTheShareOfEachLight) {
    // A floor gets half of the light of a bulb close above its middle; the other light faces up.
    Scene scene;
    add(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    scene.point_light.push_back({{0, 1e-3f, 0}, Rgb(1, 1, 1), "light 'bulb'"});
    scene.spot_light.push_back({{0, 0.5f, 0}, {0, 1, 0}, Rgb(1, 1, 1), 0.99, 0.9, "light 'up'"});
    scene.spot_light.push_back({{0, 0.5f, 0}, {0, -1, 0}, Rgb(1, 1, 1), 0.99, 0.9, "light 'down'"});
    const Pilot pilot = pilot_of(scene);
    ASSERT_EQ(pilot.light.size(), 3u);
    EXPECT_EQ(pilot.light[0].light, "light 'bulb'");
    EXPECT_NEAR(pilot.light[0].missed, 0.5, z_for(1e-5) * 0.5 / std::sqrt(4096.0) + 1e-3);
    EXPECT_EQ(pilot.light[1].missed, 1);
    EXPECT_EQ(pilot.light[2].missed, 0);
}

TEST(Pilot, TellsBacksFromFronts) {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    scene.point_light.push_back({{50, 50, 50}, Rgb(1, 1, 1), "outside"});
    scene.point_light.push_back({{0, 0, 0}, Rgb(1, 1, 1), "inside"});
    const Pilot pilot = pilot_of(scene);
    EXPECT_LT(pilot.light[0].missed, 0.7) << "of its cone the box has more than a third";
    EXPECT_EQ(pilot.light[0].on_backs, 1);
    EXPECT_EQ(pilot.light[1].on_backs, 0);

    for (Material& material : scene.material) material.double_sided = true;
    EXPECT_EQ(pilot_of(scene).light[0].on_backs, 0);
}

TEST(Pilot, FollowsMirrorsToWhatStores) {
    Scene scene;
    add(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), mirror());
    scene.spot_light.push_back({{0, 1, 0}, {0, -1, 0}, Rgb(1, 1, 1), 0.99, 0.99});
    EXPECT_EQ(pilot_of(scene).light[0].missed, 1) << "reflected to nowhere";
    add(scene, quad({-1, 2, -1}, {2, 0, 0}, {0, 0, 2}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    EXPECT_EQ(pilot_of(scene).light[0].missed, 0) << "reflected to a ceiling";
}

TEST(Pilot, FollowsHolesToWhatStores) {
    // The light through the quarter of the sheet that is open is lost, the rest is not.
    Scene scene;
    Material sheet = diffuse(Rgb(0.5f, 0.5f, 0.5f));
    sheet.alpha_mode = common::AlphaMode::blend;
    sheet.alpha = 0.75f;
    add(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), sheet);
    scene.spot_light.push_back({{0, 1, 0}, {0, -1, 0}, Rgb(1, 1, 1), 0.99, 0.99});
    EXPECT_NEAR(pilot_of(scene).light[0].missed, 0.25, z_for(1e-5) * std::sqrt(0.25 * 0.75 / 4096));
    // A floor below that faces down gets this light on its back.
    add(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 0, 2}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    const Pilot pilot = pilot_of(scene);
    EXPECT_EQ(pilot.light[0].missed, 0);
    EXPECT_NEAR(pilot.light[0].on_backs, 0.25, z_for(1e-5) * std::sqrt(0.25 * 0.75 / 4096));
}

TEST(Pilot, SendsPhotonsFromAllThatShinesOnATexture) {
    // Half of the panel's texture is above a floor that its light hits, half beyond the floor's edge.
    Scene scene;
    add(scene, quad({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    Material panel = diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1));
    panel.emissive_texture = {0, 0};
    add(scene, quad({-1, 1e-3f, 0}, {2, 0, 0}, {0, 0, 1}), panel);
    scene.texture.emplace_back("white", 64, 64, std::vector<std::uint8_t>(std::size_t{3 * 64 * 64}, 255),
                               common::ColorSpace::srgb, common::Wrap::repeat, common::Wrap::repeat);
    EXPECT_NEAR(pilot_of(scene).light[0].missed, 0.5, z_for(1e-5) * 0.5 / std::sqrt(4096.0) + 5e-3);
}

/// Makes a room with a lamp, and a spot outside that shines away from it with a thousand times the light.
Scene room_and_stray_light() {
    Scene scene = room_with_lamp();
    scene.spot_light.push_back({{0, 3, 0}, {0, 1, 0}, Rgb(5000, 5000, 5000), 0.9, 0.8, "light 'stray'"});
    return scene;
}

TEST(PhotonsByReach, GoWhereTheyArrive) {
    const Scene scene = room_and_stray_light();
    const RayScene rays(scene);
    const auto missed = [&](const PhotonSource& source) {
        common::NullSink sink;
        return common::trace_photons(rays, source, 1, {.photons = 20'000}, sink).fates.missed;
    };
    EXPECT_GT(missed(PhotonSource(scene)), 19'900u);
    EXPECT_LT(missed(PhotonSource(rays)), 19'600u) << "a hundredth of the stray light: 97.4 %";
}

TEST(PhotonsByReach, BringTheSameLight) {
    const Scene scene = room_and_stray_light();
    const RayScene rays(scene);
    constexpr std::uint64_t seed = 3, photons = count_for(400'000, 40'000);
    common::RecordingSink sink;
    const auto report = common::trace_photons(rays, PhotonSource(rays), seed, {.photons = photons}, sink);
    double light = 0;
    for (const Rgb& flux : sink.hits().flux) light += flux.x * report.watts_per_flux();
    // Every wall reflects half, so what arrives is twice the lamp's power. What falls on the lamp is missing:
    // it reflects nothing and has 3 % of the walls' area. Of the photons, 2.6 % come from the lamp. Each has
    // two hits on average, with a mean square of six.
    const double power = pi * 0.36;
    const double relative_error = std::sqrt(6 / (0.026 * static_cast<double>(photons))) / 2;
    EXPECT_NEAR(light, 2 * power, (z_for(1e-5) * relative_error + 0.05) * 2 * power) << "seed " << seed;
}

TEST(PhotonsByReach, AreTheSameWhereNothingIsLost) {
    Scene scene = room_with_lamp();
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(1, 2, 3)});
    const RayScene rays(scene);
    const PhotonSource plain(scene), piloted(rays);
    EXPECT_EQ(piloted.most_events(), common::max_events);
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const common::EmittedPhoton a = plain.emit(1, i), b = piloted.emit(1, i);
        ASSERT_EQ(a.origin, b.origin);
        ASSERT_EQ(a.direction, b.direction);
        ASSERT_EQ(a.flux, b.flux);
    }
}

TEST(EndlessLight, IsGivenUpSoon) {
    Scene scene = closed_box(diffuse(Rgb(1, 1, 1)));
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(1, 1, 1)});
    const RayScene rays(scene);
    const PhotonSource source(rays);
    EXPECT_GE(source.pilot().endless, 15.0 / 16);
    EXPECT_EQ(source.most_events(), common::max_events_of_endless_light);
    common::RecordingSink sink;
    const auto report = common::trace_photons(rays, source, 1, {.photons = 512}, sink);
    EXPECT_GE(report.fates.given_up, 500u);
    EXPECT_LE(report.hits, 512u * common::max_events_of_endless_light);
}

TEST(EndlessLight, IsNoneWhereItLeavesOrIsTaken) {
    Scene open = closed_box(diffuse(Rgb(1, 1, 1)));
    open.triangle.pop_back();  // half a wall
    open.geometric_normal.pop_back();
    open.instance_of.pop_back();
    --open.instance.back().triangle_count;
    Scene grey = closed_box(diffuse(Rgb(0.99f, 0.99f, 0.99f)));
    for (Scene* scene : {&open, &grey}) {
        scene->point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(1, 1, 1)});
        const RayScene rays(*scene);
        const PhotonSource source(rays);
        EXPECT_EQ(source.pilot().endless, 0);
        EXPECT_EQ(source.most_events(), common::max_events);
    }
}

}  // namespace
