#include <gtest/gtest.h>

#include "common/core/input_error.h"
#include "common/view/camera_rays.h"
#include "common/view/place_camera.h"
#include "common/view/visible_surfaces.h"
#include "tests/support/scene_builder.h"

namespace {

using namespace tests;
using common::Camera;
using common::CameraRays;
using common::RayScene;
using common::VisibleSurface;

constexpr float quarter_turn = static_cast<float>(pi / 2);

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
    EXPECT_LT((a - b).length(), tolerance) << a << b;
}

std::vector<VisibleSurface> look(const Scene& scene, const Camera& camera, int width, int height) {
    const RayScene rays(scene);
    return common::visible_surfaces(rays, camera, width, height);
}

/// Returns what lies straight ahead.
VisibleSurface look_at_center(const Scene& scene, const Vec3& eye, const Vec3& target) {
    return look(scene, common::look_at(eye, target, quarter_turn), 1, 1)[0];
}

// --- rays
// ----------------------------------------------------------------------------------------------------------

TEST(CameraRays, SpanTheFieldOfView) {
    const Camera camera = common::look_at({1, 2, 3}, {1, 2, -7}, quarter_turn);
    const CameraRays rays(camera, 201, 101);
    expect_near(rays.direction(100, 50), {0, 0, -1});
    // The image plane at distance 1 extends from -1 to 1 in height, and 201 / 101 times as far in width.
    const float y = 100.0f / 101, x = 200.0f / 201 * 201 / 101;
    expect_near(rays.direction(100, 0), Vec3(0, y, -1).normalized());
    expect_near(rays.direction(100, 100), Vec3(0, -y, -1).normalized());
    expect_near(rays.direction(200, 50), Vec3(x, 0, -1).normalized());
    expect_near(rays.direction(0, 50), Vec3(-x, 0, -1).normalized());
    expect_near(rays.direction(0, 0), Vec3(-x, y, -1).normalized());
}

TEST(CameraRays, ArePassedThroughPixelCentres) {
    const CameraRays rays(common::look_at({0, 0, 0}, {0, 0, -1}, quarter_turn), 2, 2);
    expect_near(rays.direction(0, 0), Vec3(-0.5f, 0.5f, -1).normalized());
    expect_near(rays.direction(1, 1), Vec3(0.5f, -0.5f, -1).normalized());
}

TEST(LookAt, MakesAnUprightFrame) {
    for (const Vec3& target : {Vec3(3, 1, 2), Vec3(-1, 5, 0.1f), Vec3(0, 1, 0), Vec3(0, -4, 0)}) {
        const Camera camera = common::look_at({0, 0, 0}, target, 1);
        expect_near(camera.forward, target.normalized());
        EXPECT_NEAR(camera.up.length(), 1, 1e-6);
        EXPECT_NEAR(camera.up.dot(camera.forward), 0, 1e-6);
        EXPECT_GE(camera.up.y, -1e-6f);
        EXPECT_EQ(camera.vertical_fov, 1);
    }
    EXPECT_THROW((void)common::look_at({1, 2, 3}, {1, 2, 3}, 1), common::InputError);
}

TEST(PlaceCamera, SeesTheInsideOfAClosedRoom) {
    for (const Vec3& half : {Vec3(1, 1, 1), Vec3(5, 1, 3), Vec3(1, 8, 1)}) {
        const Scene scene = closed_box(diffuse(Rgb(1, 1, 1)), -half, half);
        const Camera camera = common::place_camera(RayScene(scene));
        EXPECT_TRUE(scene.bounds.intersects(camera.eye)) << camera.eye;
        for (const VisibleSurface& seen : look(scene, camera, 32, 18)) {
            ASSERT_TRUE(seen.present);
            ASSERT_TRUE(seen.point.front);
        }
    }
}

TEST(PlaceCamera, SeesAnObjectFromOutside) {
    Scene scene;
    add(scene, sphere({3, 4, 5}, 2, 3), diffuse(Rgb(1, 1, 1)));
    const Camera camera = common::place_camera(RayScene(scene));
    EXPECT_GT((camera.eye - Vec3(3, 4, 5)).length(), 2);
    const auto seen = look(scene, camera, 32, 18);
    const auto fronts = std::count_if(seen.begin(), seen.end(),
                                      [](const VisibleSurface& s) { return s.present && s.point.front; });
    EXPECT_GT(fronts, 32 * 18 / 20);
}

// --- what a pixel sees
// ---------------------------------------------------------------------------------------------

TEST(VisibleSurfaces, GiveThePointUnderEachPixel) {
    Scene scene;
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), diffuse(Rgb(0.25f, 0.5f, 0.75f), Rgb(1, 2, 3)));
    const auto seen = look(scene, common::look_at({0, 0, 1}, {0, 0, 0}, quarter_turn), 2, 2);
    expect_near(seen[0].point.position, {-0.5f, 0.5f, 0});
    expect_near(seen[1].point.position, {0.5f, 0.5f, 0});
    expect_near(seen[2].point.position, {-0.5f, -0.5f, 0});
    for (const VisibleSurface& s : seen) {
        EXPECT_TRUE(s.present);
        EXPECT_EQ(s.throughput, Rgb(1, 1, 1));
        EXPECT_EQ(s.reflectance, Rgb(0.25f, 0.5f, 0.75f));
        EXPECT_EQ(s.emitted, Rgb(1, 2, 3));
        EXPECT_EQ(s.point.geometric_normal, Vec3(0, 0, 1));
    }
}

TEST(VisibleSurfaces, BacksEmitOnlyWhereBothFacesDo) {
    for (const bool both : {false, true}) {
        Scene scene;
        Material material = diffuse(Rgb(1, 1, 1), Rgb(1, 2, 3));
        material.double_sided = both;
        add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), material);
        const VisibleSurface seen = look_at_center(scene, {0, 0, -1}, {0, 0, 0});
        EXPECT_TRUE(seen.present);
        EXPECT_FALSE(seen.point.front);
        EXPECT_EQ(seen.point.geometric_normal, Vec3(0, 0, -1));
        EXPECT_EQ(seen.emitted, both ? Rgb(1, 2, 3) : Rgb(0, 0, 0));
    }
}

TEST(VisibleSurfaces, ShowTheSkyWhereThereIsNothing) {
    Scene scene;
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), mirror(Rgb(0.5f, 1, 1)));
    const VisibleSurface dark = look_at_center(scene, {0, 0, 1}, {0, 0, 5});
    EXPECT_FALSE(dark.present);
    EXPECT_EQ(dark.emitted, Rgb(0, 0, 0));
    scene.sky = common::Sky{Rgb(1, 2, 3)};
    const VisibleSurface sky = look_at_center(scene, {0, 0, 1}, {0, 0, 5});
    EXPECT_FALSE(sky.present);
    EXPECT_EQ(sky.emitted, Rgb(1, 2, 3));
    const VisibleSurface reflected = look_at_center(scene, {0, 0, 1}, {0, 0, 0});
    EXPECT_FALSE(reflected.present);
    EXPECT_EQ(reflected.throughput * reflected.emitted, Rgb(0.5f, 2, 3));
}

TEST(VisibleSurfaces, FollowMirrors) {
    // Two mirrors at 45 degrees make a periscope: the ray enters along -z, goes down, and continues along -z.
    Scene scene;
    const float h = 0.5f;
    add(scene, quad({-h, h, -h}, {1, 0, 0}, {0, 1, 1}), mirror(Rgb(0.5f, 1, 1)));
    add(scene, quad({-h, -1 - h, -h}, {1, 0, 0}, {0, 1, 1}), mirror(Rgb(1, 0.5f, 1)));
    const std::uint32_t wall = add(scene, quad({-9, -9, -3}, {18, 0, 0}, {0, 18, 0}), diffuse(Rgb(1, 1, 1)));
    const VisibleSurface seen = look_at_center(scene, {0, 1, 4}, {0, 1, 0});
    ASSERT_TRUE(seen.present);
    EXPECT_EQ(scene.instance_of[seen.point.surface.triangle], wall);
    expect_near(seen.point.position, {0, -1, -3}, 1e-4f);
    EXPECT_EQ(seen.throughput, Rgb(0.5f, 0.5f, 1));
}

TEST(VisibleSurfaces, LookThroughGlass) {
    // A slab of thickness 1 shifts a ray sideways by sin(i) (1 - cos(i) / (n cos(t))).
    Scene scene;
    const float n = 1.5f;
    Material tinted = glass(n);
    tinted.base_color = Rgb(0.5f, 1, 1);
    add(scene, quad({-9, -9, 1}, {18, 0, 0}, {0, 18, 0}), tinted);
    add(scene, quad({-9, -9, 0}, {0, 18, 0}, {18, 0, 0}), tinted);
    add(scene, quad({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}), diffuse(Rgb(1, 1, 1)));
    const VisibleSurface seen = look_at_center(scene, {-2, 0, 3}, {0, 0, 1});
    ASSERT_TRUE(seen.present);
    const float sine = std::sqrt(0.5f) / n;
    expect_near(seen.point.position, {sine / std::sqrt(1 - sine * sine) + 2, 0, -2}, 1e-4f);
    EXPECT_EQ(seen.throughput, Rgb(0.25f, 1, 1));
}

TEST(VisibleSurfaces, GlassWithoutRefractionShowsWhatIsBehindIt) {
    // A coarse ball with smooth normals: near its outline, they face away from the camera. With the index of
    // air it must be invisible all the same.
    Scene wall;
    add(wall, quad({-9, -9, -3}, {18, 0, 0}, {0, 18, 0}), diffuse(Rgb(1, 1, 1)));
    Scene with_ball = wall;
    add(with_ball, sphere({0, 0, 0}, 1, 1), glass(1.0f));
    const Camera camera = common::look_at({0.1f, 0.2f, 4}, {0, 0, 0}, 0.7f);
    const auto clear = look(wall, camera, 64, 64), through = look(with_ball, camera, 64, 64);
    int bent = 0;
    for (std::size_t i = 0; i < clear.size(); ++i)
        bent += !through[i].present || (through[i].point.position - clear[i].point.position).length() > 1e-3f;
    EXPECT_EQ(bent, 0) << "of " << clear.size() << " pixels";
}

TEST(VisibleSurfaces, EveryPixelOfAMirrorBallShowsTheRoom) {
    Scene scene = closed_box(diffuse(Rgb(1, 1, 1)), {-5, -5, -5}, {5, 5, 5});
    add(scene, sphere({0, 0, 0}, 1, 1), mirror());
    const auto seen = look(scene, common::look_at({0.1f, 0.2f, 4}, {0, 0, 0}, 0.7f), 64, 64);
    const auto lost =
        std::count_if(seen.begin(), seen.end(), [](const VisibleSurface& s) { return !s.present; });
    EXPECT_EQ(lost, 0) << "of " << seen.size() << " pixels";
}

}  // namespace
