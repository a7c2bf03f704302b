// Tests that photons, cameras and the reference hit the same one of coinciding triangles.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "bench/experiments/limit/replay.h"
#include "bench/experiments/stability/known_light.h"
#include "photonmap/photon_sinks.h"
#include "shlm/map/sink.h"
#include "tests/support/reference_tracing.h"
#include "tests/support/statistics.h"
#include "tests/support/texels.h"
#include "tests/support/tracing.h"

namespace {

using namespace bench::limit;
using bench::stability::mean_irradiance;
using namespace tests;
using common::RayScene;
using common::Vec3Array;

const Material light = diffuse(Rgb(0.9f, 0.9f, 0.9f)), dark = diffuse(Rgb(0.1f, 0.1f, 0.1f)),
               black = diffuse(Rgb(0, 0, 0)), lamp = diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1));

Mesh other_diagonal(Mesh quad) {
    quad.triangle = {{0, 1, 3}, {1, 2, 3}};
    return quad;
}

Mesh reversed(Mesh mesh) {
    for (common::TriangleVertices& corners : mesh.triangle) std::swap(corners[1], corners[2]);
    return mesh;
}

/// A quad of area 4 in the plane z = 0, facing up, and one of a quarter of its width in the middle.
const Mesh large = quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}),
           small = quad({-0.25f, -0.25f, 0}, {0.5f, 0, 0}, {0, 0.5f, 0});

Material with_alpha(common::AlphaMode mode, float alpha) {
    Material material = light;
    material.alpha_mode = mode;
    material.alpha = alpha;
    return material;
}

Scene scene_of(const std::vector<std::pair<Mesh, Material>>& parts) {
    Scene scene;
    for (const auto& [mesh, material] : parts) add(scene, mesh, material);
    return scene;
}

struct Rays {
    Vec3Array origin, direction;
};

/// Makes rays from random points on one side of the quad whose first triangle is `target` to random points on
/// it.
Rays rays_to(const Scene& scene, std::uint32_t target, float side, std::size_t count) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    Rays rays;
    rays.origin.resize(count);
    rays.direction.resize(count);
    const Vec3 normal = scene.geometric_normal[target] * side;
    const Vec3* const vertex = &scene.position[scene.triangle[target][0]];
    const Vec3 corner = vertex[0], edge_u = vertex[1] - corner, edge_v = vertex[3] - corner;
    const auto somewhere = [&] {
        const float u = uniform(engine), v = uniform(engine);
        return corner + edge_u * u + edge_v * v;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 origin = somewhere() + normal * (0.01f + uniform(engine));
        rays.origin.set(i, origin);
        rays.direction.set(i, (somewhere() - origin).normalized());
    }
    return rays;
}

bool same_bits(const SurfaceId& a, const SurfaceId& b) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return a.triangle == b.triangle && bits(a.u) == bits(b.u) && bits(a.v) == bits(b.v);
}

constexpr std::size_t ray_count = count_for(5'000, 1'000);

/// Expects rays from this side of the quad `target` to hit, alone and in packets, the instance that
/// `expected` returns for the hit point.
template <class Expected>
void expect_met(const Scene& scene, std::uint32_t target, float side, const Expected& expected) {
    const RayScene rays(scene);
    const Rays some = rays_to(scene, target, side, ray_count);
    common::NearestSurfaces found;
    rays.nearest(some.origin, some.direction, found);
    for (std::size_t i = 0; i < ray_count; ++i) {
        const auto alone = rays.nearest(some.origin[i], some.direction[i]);
        ASSERT_TRUE(alone) << i;
        ASSERT_TRUE(same_bits(*alone, found[i])) << "ray " << i << " alone and in a packet";
        const Vec3 at = common::position_at(scene, *alone);
        ASSERT_LT(some.direction[i].cross(at - some.origin[i]).length(), 3e-5f) << "off the ray " << i;
        ASSERT_EQ(scene.instance_of[alone->triangle], expected(at)) << "ray " << i << " at " << at;
    }
}

/// Expects the same instance everywhere, also where the quad is the first mesh of a rotated scene.
void expect_met(const Scene& scene, float side, std::uint32_t instance) {
    const auto everywhere = [=](const Vec3&) { return instance; };
    expect_met(scene, 0, side, everywhere);
    expect_met(moved(scene, skew_rotation(), {1, -0.5f, 2}), 0, side, everywhere);
}

/// Returns a function that gives `instance` in the small quad and `around` outside it.
auto in_the_middle(std::uint32_t instance, std::uint32_t around) {
    return
        [=](const Vec3& at) { return std::max(std::abs(at.x), std::abs(at.y)) < 0.25f ? instance : around; };
}

constexpr float above = 1, below = -1;

TEST(CoincidingSurfaces, OfTheSameKindTheFirstIsMet) {
    for (const Mesh& second : {large, other_diagonal(large)})
        for (const float side : {above, below}) {
            expect_met(scene_of({{large, light}, {second, dark}}), side, 0);
            expect_met(scene_of({{second, dark}, {large, mirror()}}), side, 0);
        }
}

TEST(CoincidingSurfaces, AreMetWhereTheyAre) {
    for (const Mesh& middle : {small, other_diagonal(small)})
        for (const float side : {above, below}) {
            expect_met(scene_of({{large, light}, {middle, dark}}), side, 0);
            expect_met(scene_of({{middle, light}, {large, dark}}), 2, side, in_the_middle(0, 1));
        }
}

TEST(CoincidingSurfaces, BackToBackEachAnswersForItsSide) {
    for (const Mesh& back : {reversed(large), reversed(other_diagonal(large))}) {
        expect_met(scene_of({{large, light}, {back, dark}}), above, 0);
        expect_met(scene_of({{large, light}, {back, dark}}), below, 1);
    }
    expect_met(scene_of({{large, light}, {reversed(small), dark}}), 0, below, in_the_middle(1, 0));
    expect_met(scene_of({{large, light}, {reversed(small), dark}}), above, 0);
}

TEST(CoincidingSurfaces, OfTwoSidesTheFirstAnswersForBoth) {
    for (const float side : {above, below}) {
        expect_met(scene_of({{large, double_sided(light)}, {reversed(large), double_sided(light)}}), side, 0);
        expect_met(scene_of({{large, double_sided(light)}, {reversed(large), dark}}), side, 0);
    }
    expect_met(scene_of({{large, light}, {large, double_sided(dark)}}), above, 0);
    expect_met(scene_of({{large, light}, {large, double_sided(dark)}}), below, 1);
}

TEST(CoincidingSurfaces, OneThatLetsNoLightThroughIsMetFirst) {
    for (const Material& open :
         {with_alpha(common::AlphaMode::blend, 0.5f), glass(), with_alpha(common::AlphaMode::mask, 0.4f)})
        for (const Mesh& mesh : {large, reversed(large)})
            for (const float side : {above, below}) {
                expect_met(scene_of({{mesh, open}, {large, light}}), side, 1);
                expect_met(scene_of({{mesh, double_sided(open)}, {large, mirror()}}), side, 1);
            }
    expect_met(scene_of({{large, with_alpha(common::AlphaMode::blend, 1)}, {small, light}}), 0, above,
               in_the_middle(1, 0));
}

TEST(CoincidingSurfaces, AMaskIsMetWhereItHasNoHoles) {
    const Material solid = with_alpha(common::AlphaMode::mask, 0.6f);
    expect_met(scene_of({{large, solid}, {large, dark}}), above, 1);
    expect_met(scene_of({{large, solid}, {reversed(large), dark}}), above, 0);
    expect_met(scene_of({{large, solid}, {reversed(large), dark}}), below, 1);
    expect_met(scene_of({{large, glass()}, {large, solid}}), above, 1);
}

TEST(CoincidingSurfaces, ALampIsMetBeforeTheCeilingThatItIsIn) {
    expect_met(scene_of({{large, dark}, {small, lamp}}), 0, above, in_the_middle(1, 0));
    expect_met(scene_of({{large, dark}, {small, lamp}}), below, 0);
    expect_met(scene_of({{large, lamp}, {large, diffuse(Rgb(0, 0, 0), Rgb(2, 2, 2))}}), above, 0);
}

TEST(CoincidingSurfaces, AreMetInPacketsForManyTriangles) {
    Scene scene = scene_of({{large, light}, {other_diagonal(large), dark}});
    add(scene, sphere({0, 0, 9}, 1, 7), light);
    ASSERT_GT(scene.triangle.size(), 50'000u) << "packets of 8";
    expect_met(scene, 0, above, [](const Vec3&) { return 0u; });
}

TEST(CoincidingSurfaces, OtherSurfacesStayWhereTheyAre) {
    // These quads are below the floor that coincides, and perpendicular to it: neither is in its plane.
    Scene scene = scene_of({{large, light}, {large, dark}});
    add(scene, quad({-1, -1, -0.001f}, {2, 0, 0}, {0, 2, 0}), light);
    add(scene, quad({0, -1, -1}, {0, 2, 0}, {0, 0, 2}), light);
    const RayScene rays(scene);
    EXPECT_EQ(rays.coinciding_triangles().triangle, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(scene.instance_of[rays.nearest({0.5f, 0.3f, -0.5f}, {0, 0, 1})->triangle], 2u);
    EXPECT_EQ(scene.instance_of[rays.nearest({0.5f, 0.3f, 0.5f}, {-1, 0, 0})->triangle], 3u);
    EXPECT_FALSE(rays.nearest({0.5f, 0.3f, 0.5f}, {0, 0, 1}));
    EXPECT_TRUE(rays.occluded({0.5f, 0.3f, 0.5f}, {0, 0, -1}, 1));
    EXPECT_FALSE(rays.occluded({0.5f, 0.3f, 0.5f}, {0, 0, -1}, 0.4f));
}

// --- light

/// Makes a box that is black except for its floor, which exists twice. The light that reaches the ceiling by
/// way of the floor shows which of both was hit.
Scene box_with_two_floors(const Material& first, const Material& second) {
    const auto walls = box_walls({-1, -1, -1}, {1, 1, 1});
    Scene scene;
    add(scene, walls[5], black);
    for (std::size_t i = 0; i < 4; ++i) add(scene, walls[i], black);
    add(scene, walls[4], first);
    add(scene, other_diagonal(walls[4]), second);
    scene.point_light.push_back({{0.1f, 0.2f, -0.3f}, Rgb(10, 10, 10)});
    return scene;
}

std::vector<SurfacePoint> on_the_ceiling(const Scene& scene) {
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j)
            points.push_back(front_of(
                scene, on_quad(0, 0.25f + static_cast<float>(i) / 24, 0.25f + static_cast<float>(j) / 24)));
    return points;
}

/// Means over the points, one value per seed.
struct Answers {
    Sample photon_map, light_map;
};

Answers answers_at(const Scene& scene, std::span<const SurfacePoint> points) {
    const shlm::PreparedTexels texels = texels_of(scene, 4000);
    const photonmap::GatherSettings gather{photonmap::FixedRadius{0.03}, photonmap::Kernel::disc, 0};
    Answers answers;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        photonmap::FlannPhotonSink photons(scene, gather);
        shlm::Sink<shlm::PaperModel> sums(texels, shlm::OwnTexel{}, quantum_for(scene), 0);
        Tee both(photons, sums);
        const common::TraceReport report = trace(scene, seed, {.photons = count_for(60'000, 12'000)}, both);
        const auto photon_map = std::move(photons).finish(report.watts_per_flux());
        const auto light_map = sums.finish(report.watts_per_flux());
        answers.photon_map.add(mean_irradiance(photon_map, points));
        answers.light_map.add(mean_irradiance(light_map, points));
    }
    return answers;
}

// Each comparison fails by chance with probability 1e-5.
TEST(CoincidingSurfaces, AllMethodsMeetTheSameFloor) {
    for (const bool light_first : {true, false}) {
        const Scene scene = light_first ? box_with_two_floors(light, dark) : box_with_two_floors(dark, light);
        const std::vector<SurfacePoint> points = on_the_ceiling(scene);
        const ReferenceSums sums = trace_reference(scene, points, 1, 33);
        double truth = 0, variance_of_truth = 0;
        const auto count = static_cast<double>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            truth += estimate(sums, i, 0) / count;
            variance_of_truth += variance(sums, i, 0) / (count * count);
        }
        const Answers answers = answers_at(scene, points);
        for (const Sample& answer : {answers.photon_map, answers.light_map}) {
            const double own_error = answer.standard_error();
            // The blur of a disc or texel, and the truncation of a series of order 2, are within 3 %.
            const double bound =
                t_for(1e-5, 7) * own_error + z_for(1e-5) * std::sqrt(variance_of_truth) + 0.03 * truth;
            EXPECT_NEAR(answer.mean(), truth, bound) << (light_first ? "light first" : "dark first");
            EXPECT_LT(bound, 0.2 * truth);
        }
    }
}

/// Makes a black box with two overlapping lamps in its middle, facing up.
Scene box_with_lamps(const Mesh& first, const Mesh& second) {
    Scene scene = closed_box(black);
    add(scene, first, lamp);
    add(scene, second, lamp);
    return scene;
}

/// Expects this power to reach the walls, in W: by photons and by the reference.
void expect_power(const Scene& scene, double power) {
    const TracedRun run = record(scene, 1, {.photons = count_for(60'000, 12'000)});
    Sample flux;  // of a photon
    for (std::size_t i = 0; i < run.hits.size(); ++i) flux.add(double{run.hits.flux[i].x});
    const auto emitted = static_cast<double>(run.report.fates.emitted);
    const double traced = flux.mean() * static_cast<double>(flux.count()) / emitted;
    const double share = static_cast<double>(flux.count()) / emitted;
    const double spread = flux.mean() * std::sqrt(share * (1 - share) / emitted);
    EXPECT_NEAR(traced, power, z_for(1e-5) * spread + rounding * power);

    const auto walls = fronts(0, 12);
    const Sample irradiance = mean_irradiance(scene, walls, count_for(200'000, 20'000));
    EXPECT_NEAR(irradiance.mean() * 24, power, z_for(1e-5) * irradiance.standard_error() * 24);
    EXPECT_LT(irradiance.standard_error() * 24, 0.05 * power);
}

TEST(CoincidingSurfaces, OfLampsThatOverlapOneShines) {
    const Mesh one = quad({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0});
    expect_power(box_with_lamps(one, other_diagonal(one)), pi);
    expect_power(box_with_lamps(one, quad({0, -0.5f, 0}, {1, 0, 0}, {0, 1, 0})), 1.5 * pi);
    expect_power(box_with_lamps(one, reversed(one)), 2 * pi);
}

// --- bench/limit

TEST(CoincidingSurfaces, ReplayedRaysAreTheRuns) {
    Scene scene = closed_box(light, {-1, -1, -1}, {1, 1, 0.5f});
    const Mesh floor = quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}),
               small_lamp = quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    add(scene, other_diagonal(floor), dark);
    add(scene, small_lamp, lamp);
    add(scene, other_diagonal(small_lamp), lamp);
    const RayScene rays(scene);
    const common::PhotonSource source(scene);
    const RecordedRun run =
        record_run(rays, source, 1, 20'000, std::size_t{1} << 30, [](const RecordedRun&) { return true; });
    EXPECT_EQ(count_differences(rays, run.blocks), 0u);
    const TracedRun traced = record(scene, 1, {.photons = run.report.fates.emitted});
    EXPECT_EQ(traced.report.hits, run.report.hits);
    EXPECT_EQ(traced.report.fates.absorbed, run.report.fates.absorbed);
    EXPECT_EQ(traced.report.fates.missed, run.report.fates.missed);
    EXPECT_EQ(traced.report.fates.escaped, run.report.fates.escaped);
}

}  // namespace
