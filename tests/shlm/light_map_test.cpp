#include "shlm/map/light_map.h"

#include <gtest/gtest.h>

#include "shlm/map/sink.h"
#include "tests/support/statistics.h"
#include "tests/support/texels.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::HitBatch;
using LightMap = shlm::HarmonicMap<shlm::PaperModel>;
using Accumulator = shlm::Accumulator<shlm::PaperModel>;
using Sink = shlm::Sink<shlm::PaperModel>;
using shlm::NearestTexels;
using shlm::PreparedTexels;
using shlm::ShWeight;

constexpr double degrees = pi / 180;

/// Makes a floor of 8 x 8 texels at z = 0, with area 4.
Scene sheet(const Material& material) {
    Scene scene;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), material);
    return scene;
}

Vec3 direction_in_xz(double angle) {
    return {static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle))};
}

/// Makes collimated light on the sheet that gives a plane facing it the irradiance (1, 2, 3). Hits are on a
/// fine grid with the same number in each texel.
HitBatch collimated_light(const Vec3& towards_light) {
    constexpr int side = 64;
    HitBatch hits;
    const float flux = 4 * std::abs(towards_light.z) / (side * side);
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const float s = (static_cast<float>(i) + 0.5f) / side, t = (static_cast<float>(j) + 0.5f) / side;
            hits.push_back({2 * s - 1, 2 * t - 1, 0}, -towards_light, Rgb(1, 2, 3) * flux, on_quad(0, s, t));
        }
    return hits;
}

template <class Model = shlm::PaperModel>
shlm::HarmonicMap<Model> map_of(const PreparedTexels& texels, const HitBatch& hits,
                                const shlm::Gather& gather = NearestTexels{}) {
    shlm::Sink<Model> sink(texels, gather, quantum_for(hits), 0);
    sink.consume(std::span(&hits, 1));
    return sink.finish(1);
}

double kernel(double x) {
    return (3 + 16 * x + 15 * x * x) / 32;
}

TEST(LightMap, OneLightGivesTheTruncatedKernel) {
    const Scene scene = sheet(diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 64);
    ASSERT_EQ(texels.layout.texel_count(), 64u);
    for (const double incidence : {0.0, 30.0, 60.0, 80.0}) {
        const Vec3 towards_light = direction_in_xz(incidence * degrees);
        const LightMap map = map_of(texels, collimated_light(towards_light));
        for (const double tilt : {-80.0, -60.0, -30.0, 0.0, 30.0, 45.0, 60.0, 80.0}) {
            common::SurfacePoint point = front_of(scene, on_quad(0, 0.3f, 0.6f));
            point.shading_normal = direction_in_xz(tilt * degrees);
            const double expected = std::max(0.0, kernel(std::cos((tilt - incidence) * degrees)));
            const Rgb irradiance = map.irradiance(point);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(irradiance[c], expected * (c + 1), 1e-5 * (c + 1))
                    << "incidence " << incidence << ", tilt " << tilt << ", channel " << c;
        }
    }
}

TEST(LightMap, OneTracedLightGivesTheTruncatedKernel) {
    constexpr std::uint64_t seed = 1;
    Scene scene = sheet(diffuse(Rgb(0, 0, 0)));
    const Vec3 towards_light = direction_in_xz(40 * degrees);
    scene.directional_light.push_back({-towards_light, Rgb(3, 3, 3)});
    const PreparedTexels texels = texels_of(scene, 64);
    Sink sink(texels, NearestTexels{}, quantum_for(scene));
    const common::TraceReport report = trace(scene, seed, {.photons = count_for(1'000'000, 50'000)}, sink);
    const LightMap map = common::finish_map(std::move(sink), report);
    Sample irradiance;
    common::SurfacePoint point = front_of(scene, on_quad(0, 0.5f, 0.5f));
    point.shading_normal = direction_in_xz(-10 * degrees);
    for (const auto& texel : map.texels()) irradiance.add(texel.irradiance(point.shading_normal).y);
    // All photons carry the same flux in the same direction, so the mean over the texels only has the noise
    // of their number.
    const double expected = 3 * kernel(std::cos(50 * degrees));
    const double error = expected / std::sqrt(static_cast<double>(report.hits));
    EXPECT_NEAR(irradiance.mean(), expected, z_for(1e-4) * error) << "seed " << seed;
}

TEST(LightMap, LiteralWeightLacksTheCosine) {
    const Scene scene = sheet(diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 64);
    const Vec3 towards_light = direction_in_xz(60 * degrees);
    const auto point = front_of(scene, on_quad(0, 0.3f, 0.6f));
    using FluxModel = shlm::TexelModel<2, ShWeight::flux>;
    EXPECT_NEAR(map_of<FluxModel>(texels, collimated_light(towards_light)).irradiance(point).x,
                0.5 * kernel(0.5), 1e-5);
}

TEST(LightMap, CutsOffWhatTheSeriesTakesBelowZero) {
    const Scene scene = sheet(diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 64);
    const LightMap map = map_of(texels, collimated_light({0, 0, 1}));
    common::SurfacePoint point = front_of(scene, on_quad(0, 0.3f, 0.6f));
    point.shading_normal = direction_in_xz(std::acos(-8.0 / 15));
    EXPECT_EQ(map.irradiance(point), Rgb(0, 0, 0));
    EXPECT_NEAR(map.texels()[0].irradiance(point.shading_normal).x, kernel(-8.0 / 15), 1e-5);
    EXPECT_LT(kernel(-8.0 / 15), -0.039);
}

TEST(LightMap, LightOnOneSideDoesNotReachTheOther) {
    const Scene scene = sheet(double_sided(diffuse(Rgb(1, 1, 1))));
    const PreparedTexels texels = texels_of(scene, 128);
    ASSERT_EQ(texels.layout.texel_count(), 128u);
    const SurfaceId surface = on_quad(0, 0.3f, 0.6f);
    const auto front = front_of(scene, surface), back = common::surface_point_at(scene, surface, {0, 0, 1});
    for (const float side : {1.0f, -1.0f}) {
        const LightMap map = map_of(texels, collimated_light({0, 0, side}));
        EXPECT_NEAR(map.irradiance(front).x, side > 0 ? 1.0625 : 0, 1e-5);
        EXPECT_NEAR(map.irradiance(back).x, side > 0 ? 0 : 1.0625, 1e-5);
    }
}

TEST(LightMap, BacksOfSingleSidedSurfacesStayDark) {
    const Scene scene = sheet(diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 64);
    const HitBatch from_below = collimated_light({0, 0, -1});
    Sink sink(texels, NearestTexels{}, quantum_for(from_below));
    sink.consume(std::span(&from_below, 1));
    EXPECT_EQ(sink.rejected().back_of_single_sided, from_below.size());
    const LightMap map = sink.finish(1);
    EXPECT_EQ(map.irradiance(front_of(scene, on_quad(0, 0.3f, 0.6f))), Rgb(0, 0, 0));
    EXPECT_EQ(map.irradiance(common::surface_point_at(scene, on_quad(0, 0.3f, 0.6f), {0, 0, 1})),
              Rgb(0, 0, 0));
}

TEST(LightMap, KnowsNothingFarFromItsTexels) {
    const Scene scene = sheet(diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 64);
    const LightMap map = map_of(texels, collimated_light({0, 0, 1}));
    common::SurfacePoint point = front_of(scene, on_quad(0, 0.5f, 0.5f));
    point.position.z += 0.9f;  // texels are 0.25 wide
    EXPECT_GT(map.irradiance(point).x, 0);
    point.position.z += 0.3f;
    EXPECT_EQ(map.irradiance(point), Rgb(0, 0, 0));
}

TEST(LightMap, EveryLitPointHasATexelInReach) {
    // A floor and a small plate are in one mesh, and the plate has nearly all of the lightmap. The mean texel
    // is thus far smaller than the floor's.
    const Mesh floor = with_lightmap_uv(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}),
                                        {{0, 0}, {0.125f, 0}, {0.125f, 0.125f}, {0, 0.125f}});
    const Mesh plate = with_lightmap_uv(quad({-0.1f, -0.1f, 1}, {0.2f, 0, 0}, {0, 0.2f, 0}),
                                        {{0.125f, 0}, {1, 0}, {1, 1}, {0.125f, 1}});
    Scene scene;
    add(scene, joined(floor, plate), diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 4096);  // the floor has 8 x 8 of them
    const LightMap map = map_of(texels, collimated_light({0, 0, 1}));
    int dark = 0, points = 0;
    for (float s = 0.02f; s < 1; s += 0.01f)
        for (float t = 0.02f; t < 1; t += 0.01f, ++points)
            dark += map.irradiance(front_of(scene, on_quad(0, s, t))).x == 0;
    EXPECT_EQ(dark, 0) << "of " << points << " points of an evenly lit floor";
}

/// Returns the hits of a room with every kind of surface, one batch per block.
std::vector<HitBatch> blocks_of_hits(const Scene& scene) {
    std::vector<HitBatch> batches;
    struct Collect {
        std::vector<HitBatch>& batches;
        void consume(std::span<const HitBatch> wave) {
            batches.insert(batches.end(), wave.begin(), wave.end());
        }
    } collect{batches};
    trace(scene, 2, {.photons = count_for(100'000, 20'000)}, collect);
    return batches;
}

Scene furnished_room() {
    Scene scene = closed_box(diffuse(Rgb(0.7f, 0.5f, 0.3f)));
    add(scene, quad({-0.5f, -0.5f, -0.5f}, {1, 0, 0}, {0, 1, 0}),
        double_sided(diffuse(Rgb(0.5f, 0.5f, 0.5f))));
    scene.point_light.push_back({{0, 0, 0.2f}, Rgb(3, 2, 1)});
    return scene;
}

bool same_sums(const Accumulator& a, const Accumulator& b) {
    for (std::size_t i = 0; i < a.sums().size(); ++i) {
        const auto x = a.sums()[i], y = b.sums()[i];
        if (x.hits != y.hits || x.value != y.value) return false;
    }
    return a.sums().size() == b.sums().size();
}

TEST(Accumulator, SumsAreTheSameOnAnyNumberOfThreadsAndForAnyWaves) {
    const Scene scene = furnished_room();
    const std::vector<HitBatch> batches = blocks_of_hits(scene);
    for (const std::size_t texel_count : {1, 63, 64, 65, 5000}) {
        const PreparedTexels texels = texels_of(scene, texel_count);
        Accumulator reference(texels.layout, quantum_for(scene));
        common::ThreadPool(1).run([&] { reference.consume(batches); });
        for (const int threads : {1, 2, 7})
            for (const std::size_t wave : {std::size_t{1}, std::size_t{3}, std::size_t{64}, batches.size()}) {
                Accumulator other(texels.layout, quantum_for(scene));
                common::ThreadPool(threads).run([&] {
                    for (std::size_t i = 0; i < batches.size(); i += wave)
                        other.consume(std::span(batches).subspan(i, std::min(wave, batches.size() - i)));
                });
                EXPECT_TRUE(same_sums(reference, other))
                    << threads << " threads, waves of " << wave << ", " << texel_count << " texels";
                EXPECT_EQ(reference.rejected().total(), other.rejected().total());
            }
    }
}

TEST(Accumulator, SumsAreThoseOfPlainAddition) {
    const Scene scene = furnished_room();
    const PreparedTexels texels = texels_of(scene, 700);
    const HitBatch hits = record(scene, 3, {.photons = 5'000}).hits;
    Accumulator accumulator(texels.layout, quantum_for(scene));
    accumulator.consume(std::span(&hits, 1));
    std::vector<shlm::TexelSum<shlm::PaperModel>> expected(texels.layout.texel_count());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const shlm::TriangleTexels& triangle = texels.layout.triangle(hits.surface[i].triangle);
        const float cosine = -hits.direction[i].dot(scene.geometric_normal[hits.surface[i].triangle]);
        auto& sum = expected[shlm::texel_at(triangle, hits.surface[i].u, hits.surface[i].v, cosine >= 0)];
        const auto y = shlm::evaluate_sh<2>(-hits.direction[i]);
        for (std::size_t k = 0; k < y.size(); ++k)
            for (int c = 0; c < 3; ++c)
                sum.value[3 * k + static_cast<std::size_t>(c)] +=
                    double{hits.flux[i][c]} * y[k] / std::max(double{std::abs(cosine)}, 1e-3);
        ++sum.hits;
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(accumulator.sums()[i].hits, expected[i].hits);
        for (std::size_t k = 0; k < expected[i].value.size(); ++k)
            ASSERT_NEAR(accumulator.sums()[i].value[k], expected[i].value[k],
                        1e-5 * std::abs(expected[i].value[0] + expected[i].value[1] + expected[i].value[2]));
    }
}

TEST(Accumulator, MemoryDoesNotGrowWithHits) {
    const Scene scene = furnished_room();
    const PreparedTexels texels = texels_of(scene, 700);
    const std::vector<HitBatch> batches = blocks_of_hits(scene);
    Accumulator accumulator(texels.layout, quantum_for(scene));
    accumulator.consume(batches);
    const std::size_t bytes = accumulator.bytes();
    EXPECT_GE(bytes, texels.layout.texel_count() * shlm::TexelSums<shlm::PaperModel>::bytes_per_texel());
    for (int i = 0; i < 20; ++i) accumulator.consume(batches);
    EXPECT_EQ(accumulator.bytes(), bytes);

    const LightMap once = map_of(texels, batches[0]);
    Sink sink(texels, NearestTexels{}, quantum_for(scene));
    for (int i = 0; i < 20; ++i) sink.consume(batches);
    // The index is measured at the allocator, which rounds sizes.
    const auto expected = static_cast<double>(once.bytes());
    EXPECT_NEAR(static_cast<double>(sink.finish(1).bytes()), expected, 0.02 * expected);
}

TEST(Accumulator, EqualHitsAddUpPastTheReachOfFloat) {
    const Scene scene = sheet(diffuse(Rgb(1, 1, 1)));
    const PreparedTexels texels = texels_of(scene, 1);
    HitBatch hits;
    for (int i = 0; i < (1 << 16); ++i)
        hits.push_back({0, 0, 0}, {0, 0, -1}, Rgb(1, 1, 1), on_quad(0, 0.5f, 0.5f));
    Accumulator accumulator(texels.layout, quantum_for(hits));
    constexpr int waves = static_cast<int>(count_for(1 << 9, 1 << 4));
    for (int i = 0; i < waves; ++i) accumulator.consume(std::span(&hits, 1));
    const double expected = static_cast<double>(waves) * (1 << 16) / std::sqrt(4 * pi);
    EXPECT_NEAR(accumulator.sums()[0].value[0], expected, 1e-6 * expected);
    EXPECT_EQ(accumulator.sums()[0].hits, static_cast<std::uint64_t>(waves) << 16);
}

}  // namespace
