// Tests the reference where the answer is known: direct light and diffuse reflection.
#include "tests/support/reference_tracing.h"

namespace {

using namespace tests;

constexpr std::uint64_t seed = 1;
constexpr std::uint64_t passes = count_for(65, 17);

const Material black = diffuse(Rgb(0, 0, 0));

Material panel(float radiance) {
    return diffuse(Rgb(0, 0, 0), Rgb(radiance, radiance, radiance));
}

/// Makes a floor of 4 x 4 in the plane y = 0, facing up.
Mesh floor_mesh() {
    return quad({-2, 0, -2}, {0, 0, 4}, {4, 0, 0});
}

/// Returns points on the floor, which must be the scene's first mesh.
std::vector<SurfacePoint> on_floor(const Scene& scene, std::initializer_list<Vec2> xz) {
    std::vector<SurfacePoint> points;
    for (const Vec2& p : xz) points.push_back(front_of(scene, on_quad(0, (p.y + 2) / 4, (p.x + 2) / 4)));
    return points;
}

// --- furnace: every wall emits 1 and reflects rho, so radiance is 1 / (1 - rho) everywhere

TEST(ReferenceFurnace, IsRightAtEveryTilt) {
    const Rgb albedo(0.8f, 0.5f, 0.2f);
    const Scene furnace = closed_box(diffuse(albedo, Rgb(1, 1, 1)));
    std::mt19937 engine(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> turn(0, 1);
    std::vector<SurfacePoint> points;
    std::vector<V3d> expected;
    for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0})
        for (int i = 0; i < 10; ++i) {
            const double tilt = degrees * pi / 180;
            points.push_back(tilted(random_point(furnace, fronts(0, 12), engine), tilt, turn(engine)));
            // The wall covers the rest of a tilted plane's hemisphere.
            const double open = pi * (1 + std::cos(tilt)) / 2;
            expected.emplace_back(open / (1 - 0.8), open / (1 - 0.5), open / (1 - 0.2));
        }
    expect_irradiance(trace_reference(furnace, points, seed, passes), expected);
}

// --- direct light of panels

TEST(ReferencePanel, ParallelToTheFloor) {
    Scene scene;
    add(scene, floor_mesh(), black);
    const Mesh lamp = quad({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1});  // faces down
    add(scene, lamp, panel(3));
    const auto points = on_floor(scene, {{0, 0}, {0.5f, 0.5f}, {1.9f, -1.9f}, {-1, 0.3f}});
    std::vector<double> expected;
    for (const SurfacePoint& p : points)
        expected.push_back(3 * lambert(lamp.position, p.position, p.shading_normal));
    // For a point below the middle, the catalogue of form factors gives four corners with a / c = 1/2
    // (Howell, configuration B-4).
    const double x = 0.5 / std::sqrt(1.25);
    EXPECT_NEAR(expected[0], 3 * pi * 4 / (2 * pi) * 2 * x * std::atan(x), 1e-6);
    expect_irradiance(trace_reference(scene, points, seed, passes), expected);
}

TEST(ReferencePanel, ParallelToTiltedNormals) {
    Scene scene;
    add(scene, floor_mesh(), black);
    const Mesh lamp = quad({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1});
    add(scene, lamp, panel(3));
    std::vector<SurfacePoint> points;
    std::vector<double> expected;
    for (const double turn : {0.0, 0.3, 0.7}) {
        points.push_back(
            tilted(on_floor(scene, {{0.2f, 0.1f}})[0], 0.6, turn));  // the panel stays above the horizon
        expected.push_back(3 * lambert(lamp.position, points.back().position, points.back().shading_normal));
    }
    expect_irradiance(trace_reference(scene, points, seed, passes), expected);
}

TEST(ReferencePanel, MeetsTheFloorInACorner) {
    Scene scene;
    add(scene, floor_mesh(), black);
    const Mesh wall = quad({-2, 0, -2}, {0, 2, 0}, {0, 0, 4});  // faces +x
    add(scene, wall, panel(1));
    const auto points = on_floor(scene, {{-1.99f, 0}, {-1.9f, 1.5f}, {-1, -1.9f}, {1.9f, 0}});
    std::vector<double> expected;
    for (const SurfacePoint& p : points)
        expected.push_back(lambert(wall.position, p.position, p.shading_normal));
    const ReferenceSums sums = trace_reference(scene, points, seed, passes);
    expect_irradiance(sums, expected);
    // The panel covers half the sky, so sampled directions hit it every other time. The weights bound the
    // contributions of near points on it.
    EXPECT_LT(std::sqrt(variance(sums, 0, 0) * static_cast<double>(passes)), 0.2 * expected[0]);
}

TEST(ReferencePanel, ShinesFromItsFrontOrFromBothFaces) {
    const Mesh lamp = quad({-0.5f, 1, -0.5f}, {0, 0, 1}, {1, 0, 0});  // faces up
    for (const bool both : {false, true}) {
        Scene scene;
        add(scene, floor_mesh(), black);
        add(scene, lamp, both ? double_sided(panel(2)) : panel(2));
        const auto points = on_floor(scene, {{0, 0}, {1, 1}});
        std::vector<double> expected;
        for (const SurfacePoint& p : points)
            expected.push_back(both ? 2 * lambert(lamp.position, p.position, p.shading_normal) : 0.0);
        expect_irradiance(trace_reference(scene, points, seed, passes), expected);
    }
}

TEST(ReferencePanel, WithATextureShinesAsTheTextureSays) {
    Scene scene;
    add(scene, floor_mesh(), black);
    const Vec3 corner(-1, 1, -1), edge_u(2, 0, 0), edge_v(0, 0, 2);
    Material lamp = panel(5);
    lamp.emissive_texture = {0, 0};
    add(scene, quad(corner, edge_u, edge_v), lamp);
    scene.texture.emplace_back(
        "spots", 2, 2, std::vector<std::uint8_t>{255, 0, 0, 0, 255, 40, 10, 0, 255, 0, 90, 0},
        common::ColorSpace::linear, common::Wrap::clamp_to_edge, common::Wrap::clamp_to_edge);
    const auto points = on_floor(scene, {{-0.6f, -0.6f}, {0.8f, 0.1f}});
    std::vector<V3d> expected;
    constexpr int steps = 400;  // midpoint rule: error 1e-5 for the smooth pieces
    for (const SurfacePoint& p : points) {
        V3d sum(0, 0, 0);
        for (int i = 0; i < steps * steps; ++i) {
            const Vec2 uv((static_cast<float>(i % steps) + 0.5f) / steps,
                          (static_cast<float>(i / steps) + 0.5f) / steps);
            const V3d joining = V3d(corner + edge_u * uv.x + edge_v * uv.y) - V3d(p.position);
            const double distance_sq = joining.length2();
            const double share = joining.y * joining.y / (distance_sq * distance_sq) * 4 / (steps * steps);
            sum += V3d(scene.texture[0].sample(uv)) * (5 * share);
        }
        expected.push_back(sum);
    }
    expect_irradiance(trace_reference(scene, points, seed, passes), expected);
}

TEST(ReferencePanel, WithASmallBrightSpotIsNoNoisierThanTheSpot) {
    // Of 64 x 64 texels, 2 x 2 are bright and the others black. Clamping keeps the halves at the edges.
    std::vector<std::uint8_t> pixels(3 * 64 * 64, 0);
    for (const int texel : {64 * 20 + 40, 64 * 20 + 41, 64 * 21 + 40, 64 * 21 + 41})
        for (int c = 0; c < 3; ++c) pixels[static_cast<std::size_t>(3 * texel + c)] = 255;
    Material textured = panel(1000);
    textured.emissive_texture = {0, 0};
    Scene scene;
    add(scene, floor_mesh(), black);
    add(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), textured);
    scene.texture.emplace_back("spot", 64, 64, pixels, common::ColorSpace::linear, common::Wrap::repeat,
                               common::Wrap::repeat);
    Scene twin;
    add(twin, floor_mesh(), black);
    const float texel = 2.0f / 64;
    add(twin, quad({-1 + 40 * texel, 1, -1 + 20 * texel}, {2 * texel, 0, 0}, {0, 0, 2 * texel}), panel(1000));

    const std::initializer_list<Vec2> places = {{0.3f, -0.3f}, {-1, 1}, {1.5f, 0}};
    const ReferenceSums sums = trace_reference(scene, on_floor(scene, places), seed, passes),
                        of_twin = trace_reference(twin, on_floor(twin, places), seed, passes);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double noise = std::sqrt(variance(sums, i, 0)), expected = estimate(of_twin, i, 0);
        // The twin has sharp edges; from a distance of 1 the difference is a thousandth.
        EXPECT_NEAR(estimate(sums, i, 0), expected,
                    t_for(1e-6, static_cast<int>(passes) - 1) * noise + 2e-3 * expected);
        // With uniform positions, one sample in a thousand would hit the spot, and a sample's deviation would
        // be 32 times the mean.
        EXPECT_LT(noise * std::sqrt(64.0 * static_cast<double>(passes)), 1.5 * expected);
    }
}

// --- lights without size: one sample is exact, and so is the mean

TEST(ReferenceLamp, FallsOffWithTheSquareOfTheDistance) {
    Scene scene;
    add(scene, floor_mesh(), black);
    scene.point_light.push_back({{0.5f, 2, 0}, Rgb(3, 2, 1)});
    const auto points = on_floor(scene, {{0.5f, 0}, {-1, 1.5f}});
    std::vector<V3d> expected;
    for (const SurfacePoint& p : points) {
        const double distance_sq = (V3d(p.position) - V3d(0.5, 2, 0)).length2();
        expected.push_back(V3d(3, 2, 1) * (2 / std::pow(distance_sq, 1.5)));
    }
    expect_irradiance(trace_reference(scene, points, seed, 3), expected);
}

TEST(ReferenceLamp, SpotFadesBetweenItsCones) {
    Scene scene;
    add(scene, floor_mesh(), black);
    const float inner = std::cos(0.3f), outer = std::cos(0.6f);
    scene.spot_light.push_back({{0, 1, 0}, {0, -1, 0}, Rgb(4, 4, 4), inner, outer});
    const auto points = on_floor(scene, {{0.2f, 0}, {0.5f, 0}, {0, -0.6f}, {0.7f, 0.1f}, {1.5f, 0}});
    std::vector<double> expected;
    for (const SurfacePoint& p : points) {
        const double distance_sq = 1 + V3d(p.position).length2(), cosine = 1 / std::sqrt(distance_sq);
        const double ramp =
            std::clamp((cosine - static_cast<double>(outer)) / static_cast<double>(inner - outer), 0.0, 1.0);
        expected.push_back(4 * ramp * ramp * cosine / distance_sq);
    }
    EXPECT_EQ(expected[4], 0);
    EXPECT_NEAR(expected[1] / (4 * std::pow(1.25, -1.5)), 0.28, 0.01);  // on the ramp
    expect_irradiance(trace_reference(scene, points, seed, 3), expected);
}

TEST(ReferenceLamp, SunArrivesFromWhereItIsNotHidden) {
    Scene scene;
    add(scene, floor_mesh(), black);
    add(scene, quad({-2, 1, -2}, {2, 0, 0}, {0, 0, 4}), black);  // hides the half x < 0
    const Vec3 down = Vec3(0, -2, 1).normalized();
    scene.directional_light.push_back({down, Rgb(1, 2, 3)});
    std::vector<SurfacePoint> points = on_floor(scene, {{1, 0}, {-1, 0}, {1, 1}});
    const double up = -static_cast<double>(down.y);
    std::vector<V3d> expected = {V3d(1, 2, 3) * up, V3d(0, 0, 0), V3d(1, 2, 3) * up};
    // A normal may tilt towards a sun below the surface, whose light does not arrive. The point floats, so
    // nothing else hides the sun.
    points.push_back(points[0]);
    points.back().position.y += 0.5f;
    points.back().geometric_normal = Vec3(0, 0.1f, 1).normalized();
    points.back().shading_normal = -down;
    ASSERT_GT(points.back().geometric_normal.dot(down), 0);
    expected.emplace_back(0, 0, 0);
    expect_irradiance(trace_reference(scene, points, seed, 3), expected);
}

void expect_sum_of_lamps(std::size_t count, std::uint64_t of_passes) {
    Scene scene;
    add(scene, floor_mesh(), black);
    std::mt19937 engine(static_cast<unsigned>(count));
    std::uniform_real_distribution<float> uniform(0, 1);
    for (std::size_t i = 0; i < count; ++i)
        scene.point_light.push_back({{2 * uniform(engine) - 1, 1 + uniform(engine), 2 * uniform(engine) - 1},
                                     Rgb(1, 1, uniform(engine))});
    const auto points = on_floor(scene, {{0, 0}, {0.7f, -0.3f}, {-1.5f, 1.2f}});
    std::vector<V3d> expected;
    for (const SurfacePoint& p : points) {
        V3d sum(0, 0, 0);
        for (const common::PointLight& light : scene.point_light) {
            const V3d joining = V3d(light.position) - V3d(p.position);
            sum += V3d(light.intensity) * (joining.y / std::pow(joining.length2(), 1.5));
        }
        expected.push_back(sum);
    }
    expect_irradiance(trace_reference(scene, points, seed, of_passes), expected);
}

TEST(ReferenceLamp, AFewAddUp) {
    expect_sum_of_lamps(20, passes);
}

TEST(ReferenceLamp, ManyAddUp) {
    static_assert(common::reference::most_weighed_lights < 200);
    expect_sum_of_lamps(200, passes);
}

// --- sky

TEST(ReferenceSky, LightsAnOpenFloorFromAllSides) {
    Scene scene;
    add(scene, floor_mesh(), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    scene.sky = common::Sky{Rgb(1, 2, 3)};
    std::vector<SurfacePoint> points = on_floor(scene, {{0, 0}, {1, 1}});
    points.push_back(tilted(points[0], 0.8, 0.2));
    const V3d open = V3d(1, 2, 3) * pi;
    const std::vector<V3d> expected = {open, open, open * ((1 + std::cos(0.8)) / 2)};
    expect_irradiance(trace_reference(scene, points, seed, passes), expected);
}

TEST(ReferenceSky, IsHiddenByWhatStandsBeforeIt) {
    Scene scene;
    add(scene, floor_mesh(), black);
    const Mesh roof = quad({-1, 0.5f, -1}, {2, 0, 0}, {0, 0, 2});
    add(scene, roof, black);
    scene.sky = common::Sky{Rgb(1, 1, 1)};
    const auto points = on_floor(scene, {{0, 0}, {1.2f, 0.5f}});
    std::vector<double> expected;
    for (const SurfacePoint& p : points)
        expected.push_back(pi - lambert(roof.position, p.position, p.shading_normal));
    expect_irradiance(trace_reference(scene, points, seed, passes), expected);
}

// --- closed rooms of one albedo

constexpr std::size_t room_points = count_for(10'000, 2'000);

/// A tessellated sphere differs from a round one only in its area.
TEST(ReferenceRoom, SphereIntegrates) {
    for (const float albedo : {0.0f, 0.5f, 0.8f}) {
        Scene scene;
        add(scene, sphere({1, 2, 3}, 2, 3), diffuse(Rgb(albedo, 0, 0)));
        scene.point_light.push_back({{1, 2, 3}, Rgb(1, 1, 1)});
        std::vector<LitFace> inside;
        for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) inside.push_back({t, true});
        expect_closed_room(scene, inside, 4 * pi, static_cast<double>(albedo), room_points);
    }
}

TEST(ReferenceRoom, WithThingsInIt) {
    const Material grey = diffuse(Rgb(0.6f, 0.6f, 0.6f));
    Scene scene = closed_box(grey);
    add(scene, sphere({0.3f, -0.4f, 0.1f}, 0.5f, 1), grey);
    add(scene, quad({-0.9f, -0.5f, -0.8f}, {0.8f, 0.4f, 0}, {0, 0.3f, 0.9f}), grey);
    const auto triangles = static_cast<std::uint32_t>(scene.triangle.size());
    std::vector<LitFace> faces = fronts(0, triangles);
    faces.push_back({triangles - 2, true});  // the plate's back
    faces.push_back({triangles - 1, true});
    scene.point_light.push_back({{-0.5f, 0.7f, 0.2f}, Rgb(1, 2, 3)});
    scene.spot_light.push_back({{0.8f, 0.8f, 0.8f}, Vec3(-1, -1, -1).normalized(), Rgb(5, 5, 5), 0.9f, 0.7f});
    const double spot = 5 * 2 * pi * ((1 - 0.9) + (0.9 - 0.7) / 3);
    expect_closed_room(scene, faces, 4 * pi + spot, 0.6, room_points);
}

// --- the reported variance

/// Averaged over seeds, the squared error must equal the reported variance.
TEST(ReferenceVariance, IsThatOfTheErrors) {
    Scene corner;
    add(corner, floor_mesh(), black);
    const Mesh wall = quad({-2, 0, -2}, {0, 2, 0}, {0, 0, 4});
    add(corner, wall, panel(1));
    const Scene furnace = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(1, 1, 1)));
    const SurfacePoint by_the_wall = on_floor(corner, {{-1.7f, 0}})[0];
    const struct {
        const Scene& scene;
        SurfacePoint point;
        double expected;
    } cases[] = {
        {corner, by_the_wall, lambert(wall.position, by_the_wall.position, by_the_wall.shading_normal)},
        {furnace, tilted(front_of(furnace, on_quad(0, 0.3f, 0.6f)), 0.5, 0.1), pi * (1 + std::cos(0.5))}};
    for (const auto& [scene, point, expected] : cases) {
        Sample excess, squared_error;
        for (std::uint64_t s = 0; s < count_for(2000, 100); ++s) {
            const ReferenceSums sums = trace_reference(scene, std::span(&point, 1), s, 4);
            const double error = estimate(sums, 0, 0) - expected;
            squared_error.add(error * error);
            excess.add(error * error - variance(sums, 0, 0));
        }
        EXPECT_NEAR(excess.mean(), 0, z_for(1e-5) * excess.standard_error());
        EXPECT_GT(squared_error.mean(), 0);
        EXPECT_LT(excess.standard_error(), count_for(50, 250) * 1e-3 * squared_error.mean());
    }
}

}  // namespace
