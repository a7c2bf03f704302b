// Tests light maps whose blocks are as large and as simple as the light allows.
#include "shlm/adaptive/adaptive_map.h"

#include <gtest/gtest.h>

#include <random>

#include "common/core/threads.h"
#include "shlm/adaptive/block_moments.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"
#include "tests/support/texels.h"

namespace {

using namespace tests;
using shlm::AdaptiveMap;
using shlm::AdaptiveModel;
using shlm::BlockKind;
using shlm::PreparedTexels;

const Material plain = diffuse(Rgb(0.5f, 0.5f, 0.5f));

/// Makes a floor from (0, 0) to (1, 1) at z = 0, facing up. `bend` is the slope of the vertex normals, which
/// alternates.
Scene floor_of(const Material& material, float bend = 0) {
    Scene scene;
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    if (bend != 0)
        for (const float side : {-1.0f, 1.0f, -1.0f, 1.0f})
            mesh.normal.push_back(Vec3(side * bend, bend, 1).normalized());
    add(scene, mesh, material);
    return scene;
}

SurfacePoint point_at(const Scene& scene, float s, float t) {
    return common::surface_point_at(scene, on_quad(0, s, t), {0, 0, -1});
}

/// Makes sums in which every texel has `hits(x, y)` hits of the same light, each of which adds 1 / 1000
/// W/m^2.
template <class Hits>
shlm::TexelSums<AdaptiveModel> sums_of(const PreparedTexels& texels, const Vec3& towards_light, Hits hits) {
    shlm::TexelSums<AdaptiveModel> sums(texels.geometry.size(), shlm::Quantum(Rgb(1, 1, 1) * 1e-3f));
    for (std::uint32_t i = 0; i < texels.geometry.size(); ++i) {
        const shlm::TexelGeometry& texel = texels.geometry[i];
        for (int n = hits(texel.center.x, texel.center.y); n > 0; --n)
            sums.add(i, towards_light, 1 / towards_light.z, Rgb(1, 1, 1) * (texel.area * 1e-3f));
    }
    return sums;
}

/// Makes a map with one watt per unit of the sums.
AdaptiveMap map_of(const shlm::TexelSums<AdaptiveModel>& sums, const PreparedTexels& texels,
                   double wanted_error, bool smooth) {
    return {shlm::BlockSearch(sums, texels, 1), texels.layout, wanted_error, smooth};
}

std::size_t count_of(const AdaptiveMap& map, BlockKind kind) {
    return map.blocks()[static_cast<std::size_t>(kind)];
}

TEST(AdaptiveMap, OneLightOnAFlatFloorIsOneNumber) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 4096);
    const auto sums = sums_of(texels, Vec3(0.6f, 0, 0.8f), [](float, float) { return 1000; });
    for (const bool smooth : {false, true}) {
        const AdaptiveMap map = map_of(sums, texels, 0.01, smooth);
        EXPECT_EQ(count_of(map, BlockKind::F0), 1u);
        EXPECT_EQ(std::accumulate(map.blocks().begin(), map.blocks().end(), std::size_t{0}), 1u);
        EXPECT_LT(map.bytes(), 200u) << "two triangles, one block";
        EXPECT_NEAR(map.irradiance(point_at(scene, 0.3f, 0.7f)).x, 1, 1e-3);
    }
}

TEST(AdaptiveMap, AnEdgeBetweenTexelsIsDrawnExactly) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 4096);
    const auto sums = sums_of(texels, Vec3(0, 0, 1), [](float x, float) { return x < 0.25f ? 1000 : 0; });
    const AdaptiveMap map = map_of(sums, texels, 0.01, false);
    EXPECT_EQ(count_of(map, BlockKind::F0), 4u) << "four squares of a quarter's width";
    EXPECT_EQ(count_of(map, BlockKind::dark), 4u + 2u) << "four beside them, then two of half the width";
    for (const float t : {0.1f, 0.6f}) {
        EXPECT_NEAR(map.irradiance(point_at(scene, 0.24f, t)).x, 1, 1e-3);
        EXPECT_EQ(map.irradiance(point_at(scene, 0.26f, t)).x, 0);
    }
}

TEST(AdaptiveMap, SmoothBlocksMeetHalfWay) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 4);
    const auto sums = sums_of(texels, Vec3(0, 0, 1), [](float x, float) { return x < 0.5f ? 1000 : 3000; });
    const AdaptiveMap map = map_of(sums, texels, 0.001, true);
    EXPECT_EQ(count_of(map, BlockKind::F0), 4u);
    for (const auto& [s, expected] :
         {std::pair{0.1f, 1.0}, {0.25f, 1.0}, {0.5f, 2.0}, {0.625f, 2.5}, {0.9f, 3.0}})
        EXPECT_NEAR(map.irradiance(point_at(scene, s, 0.4f)).x, expected, 0.003) << s;
}

/// Randomly distributed photons of 1 W/m^2; `hits` of them are expected. The light is uniform, or comes the
/// more from the side the more it leans.
struct RandomLight {
    Scene scene;
    PreparedTexels texels;
    shlm::TexelSums<AdaptiveModel> sums;

    RandomLight(float bend, std::size_t texel_count, std::size_t hits, unsigned seed, float lean = 0)
        : scene(floor_of(plain, bend)),
          texels(texels_of(scene, texel_count)),
          sums(texels.geometry.size(), shlm::Quantum(Rgb(1, 1, 1) / static_cast<float>(hits))) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<float> uniform(0, 1);
        const int count = std::poisson_distribution(static_cast<double>(hits))(engine);
        for (int i = 0; i < count; ++i) {
            const SurfaceId surface = on_quad(0, uniform(engine), uniform(engine));
            const Vec3 towards =
                (common::sample_cosine_hemisphere(uniform(engine), uniform(engine)) + Vec3(lean, 0, 0))
                    .normalized();
            const shlm::TriangleTexels& triangle = texels.layout.triangle(surface.triangle);
            sums.add(shlm::texel_at(triangle, surface.u, surface.v, true), towards,
                     1 / std::max(towards.z, 1e-3f), Rgb(1, 1, 1) / static_cast<float>(hits));
        }
    }
};

template <shlm::Basis B>
Rgb shown_by(const typename B::Numbers& numbers, const Vec3& face_normal, const Vec3& normal) {
    return B::irradiance(numbers, face_normal, typename B::Question(normal));
}

TEST(AdaptiveMap, ItsLightByNormalIsWhatItShows) {
    const Scene scene = floor_of(plain, 0.4f);
    const PreparedTexels texels = texels_of(scene, 4096);
    // Two lights, so that blocks of one colour and order 2 are wanted, and an edge between small and large
    // ones.
    auto sums = sums_of(texels, Vec3(0.6f, 0, 0.8f), [](float x, float) { return x < 0.3f ? 3000 : 500; });
    for (std::uint32_t i = 0; i < texels.geometry.size(); ++i)
        for (int n = 0; n < 1000; ++n)
            sums.add(i, Vec3(0, -0.8f, 0.6f), 1 / 0.6f, Rgb(2, 1, 0.5f) * (texels.geometry[i].area * 1e-3f));
    for (const bool smooth : {false, true}) {
        const AdaptiveMap map = map_of(sums, texels, 0.002, smooth);
        EXPECT_EQ(count_of(map, BlockKind::AD), 0u) << "which F2 smooths";
        EXPECT_GT(count_of(map, BlockKind::F2), 0u);
        const shlm::TexelPlaces places(texels.layout);
        for (float s = 0.013f; s < 1; s += 0.07f)
            for (float t = 0.017f; t < 1; t += 0.09f) {
                SurfacePoint point = point_at(scene, s, t);
                const auto light = map.light_at(*places.find(point));
                ASSERT_TRUE(light);
                for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.6f, 0, 0.8f), Vec3(0, -0.6f, 0.8f)}) {
                    point.shading_normal = normal;
                    const Rgb series = shown_by<shlm::HemisphereFit<2>>(
                        shlm::HemisphereFit<2>::numbers_of(light->moments, light->normal), light->normal,
                        normal);
                    const Rgb shown = map.irradiance(point);
                    for (int c = 0; c < 3; ++c) EXPECT_NEAR(std::max(series[c], 0.0f), shown[c], 2e-4f * 6);
                }
            }
    }
}

TEST(AdaptiveMap, KnowsItsFinestBlock) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 4096);
    const auto sums = sums_of(texels, Vec3(0, 0, 1), [](float x, float) { return x < 0.25f ? 1000 : 0; });
    EXPECT_EQ(map_of(sums, texels, 0.01, true).finest_block(0), 16u) << "a quarter of 64 texels";
}

/// Returns the largest difference between a basis and the fit of order 2 of its moments, over normals.
template <shlm::Basis B>
float moments_differ(const typename B::Numbers& numbers, const Vec3& normal) {
    using Fit = shlm::HemisphereFit<2>;
    const auto moments = Fit::numbers_of(shlm::moments_of(B{}, numbers, normal), normal);
    float largest = 0;
    for (const Vec3& n : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6f, 0, 0.8f),
                          Vec3(-0.48f, 0.64f, 0.6f), Vec3(0, 0.8f, -0.6f), normal}) {
        const Rgb kept = shown_by<B>(numbers, normal, n), shown = shown_by<Fit>(moments, normal, n);
        for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(kept[c] - shown[c]));
    }
    return largest;
}

template <shlm::Basis B>
float moments_of_light_differ(const shlm::BlockLight& light, const Vec3& normal) {
    return moments_differ<B>(shlm::numbers_of<B>(light, normal), normal);
}

TEST(BlockMoments, AreExactButForADistantLight) {
    const Vec3 normal(0.36f, 0.48f, 0.8f);
    shlm::BlockLight light{Rgb(3, 2, 1), {}};
    for (std::size_t i = 0; i < light.by_normal.size(); ++i)
        light.by_normal[i] = Rgb(0.3f, 0.2f, 0.1f) * std::cos(1.7f * static_cast<float>(i));
    light.by_normal[0] = Rgb(3, 2, 1);
    using namespace shlm;
    EXPECT_LT(moments_of_light_differ<HemisphereFit<0>>(light, normal), 1e-5f);
    EXPECT_LT(moments_of_light_differ<HemisphereFit<1>>(light, normal), 1e-5f);
    EXPECT_LT(moments_of_light_differ<HemisphereFit<2>>(light, normal), 1e-5f);
    EXPECT_LT(moments_of_light_differ<LuminanceFit<2>>(light, normal), 1e-5f);
    // A distant light alone, and with the sky. F2 differs most where the light is at a right angle.
    for (const float share : {1.0f, 0.5f}) {
        const Vec3 direct = Vec3(0.6f, 0, 0.8f) * (share / Vec3(0.6f, 0, 0.8f).dot(normal));
        const AmbientAndDirection::Numbers numbers = {1, 1, 1, direct.x, direct.y, direct.z};
        EXPECT_LT(moments_differ<AmbientAndDirection>(numbers, normal), 0.25f * direct.length());
        EXPECT_GT(moments_differ<AmbientAndDirection>(numbers, normal), 0.01f * direct.length());
        const auto moments =
            HemisphereFit<2>::numbers_of(moments_of(AmbientAndDirection{}, numbers, normal), normal);
        EXPECT_NEAR(shown_by<HemisphereFit<2>>(moments, normal, normal).x, 1, 1e-5f) << "its own normal";
    }
}

TEST(AdaptiveMap, NoiseIsNotStored) {
    const RandomLight light(0, 16384, 100'000, 1);
    const AdaptiveMap map = map_of(light.sums, light.texels, 0.02, false);
    // A block of all 1e5 hits has a noise of 0.3 %.
    EXPECT_LE(std::accumulate(map.blocks().begin(), map.blocks().end(), std::size_t{0}), 4u);
    EXPECT_NEAR(map.irradiance(point_at(light.scene, 0.5f, 0.5f)).x, 1, 0.05);
}

TEST(AdaptiveMap, AnErrorBelowTheNoiseIsNotPromised) {
    const RandomLight light(0, 16384, 2000, 1);
    const AdaptiveMap map = map_of(light.sums, light.texels, 1e-3, false);
    EXPECT_GT(map.estimated_error(), 1e-2) << "2000 hits know 2.2 %";
    EXPECT_LE(std::accumulate(map.blocks().begin(), map.blocks().end(), std::size_t{0}), 200u);
}

/// The estimated error of one block must match the errors of many runs.
TEST(AdaptiveMap, EstimatesItsError) {
    double error_sq = 0, estimate_sq = 0;
    constexpr unsigned runs = 100;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const RandomLight light(0, 256, 1000, seed);
        const AdaptiveMap map = map_of(light.sums, light.texels, 0.1, false);
        double sum = 0;
        constexpr int side = 16;
        for (int i = 0; i < side * side; ++i) {
            const float s = (static_cast<float>(i % side) + 0.5f) / side,
                        t = (static_cast<float>(i / side) + 0.5f) / side;
            const double error = map.irradiance(point_at(light.scene, s, t)).x - 1.0;
            sum += error * error / (side * side);
        }
        error_sq += sum / runs;
        estimate_sq += map.estimated_error() * map.estimated_error() * 1.01 / runs;  // epsilon is 0.01
    }
    EXPECT_LT(std::sqrt(error_sq / estimate_sq), 1.5);
    EXPECT_GT(std::sqrt(error_sq / estimate_sq), 1 / 1.5);
}

TEST(AdaptiveMap, BentNormalsNeedDirectionsAndFlatOnesDoNot) {
    const auto kinds_of = [](float bend, int hits) {
        const Scene scene = floor_of(plain, bend);
        const PreparedTexels texels = texels_of(scene, 64);
        const auto sums = sums_of(texels, Vec3(0.6f, 0, 0.8f), [&](float, float) { return hits; });
        return map_of(sums, texels, 0.02, false).blocks();
    };
    const auto flat = kinds_of(0, 1000), bent = kinds_of(0.5f, 1000);
    EXPECT_EQ(flat[static_cast<std::size_t>(BlockKind::F0)], 1u);
    EXPECT_EQ(bent[static_cast<std::size_t>(BlockKind::F0)], 0u);
    EXPECT_EQ(bent[static_cast<std::size_t>(BlockKind::AD)] + bent[static_cast<std::size_t>(BlockKind::YF2)] +
                  bent[static_cast<std::size_t>(BlockKind::F1)] +
                  bent[static_cast<std::size_t>(BlockKind::F2)],
              1u);
}

TEST(AdaptiveMap, DirectionsThatNoiseHidesAreNotStored) {
    const RandomLight few(0.1f, 64, 30, 1, 1), many(0.1f, 64, 300'000, 1, 1);
    EXPECT_EQ(count_of(map_of(few.sums, few.texels, 0.5, false), BlockKind::F0), 1u);
    EXPECT_EQ(count_of(map_of(many.sums, many.texels, 0.003, false), BlockKind::F0), 0u)
        << "a normal that is bent by 0.14 has up to a tenth more or less";
    const RandomLight uniform(0.1f, 64, 300'000, 1);
    EXPECT_EQ(count_of(map_of(uniform.sums, uniform.texels, 0.01, false), BlockKind::F0), 1u)
        << "which F0 has exactly";
}

TEST(AdaptiveMap, OneSearchMakesMapsOfManyErrors) {
    const RandomLight light(0.3f, 16384, 50'000, 1);
    const shlm::BlockSearch search(light.sums, light.texels, 1);
    for (const double wanted : {0.3, 0.1, 0.2}) {
        const AdaptiveMap one_of_many(search, light.texels.layout, wanted, false);
        const AdaptiveMap alone = map_of(light.sums, light.texels, wanted, false);
        EXPECT_EQ(one_of_many.blocks(), alone.blocks()) << wanted;
        EXPECT_EQ(one_of_many.estimated_error(), alone.estimated_error()) << wanted;
    }
}

TEST(AdaptiveMap, IsTheSameForAnyNumberOfThreads) {
    const RandomLight light(0.3f, 16384, 50'000, 1);
    const auto answers = [&](int threads) {
        common::ThreadPool pool(threads);
        std::vector<float> found;
        pool.run([&] {
            const AdaptiveMap map = map_of(light.sums, light.texels, 0.1, true);
            found.push_back(static_cast<float>(map.bytes()));
            for (int i = 0; i < 1000; ++i)
                found.push_back(map.irradiance(point_at(light.scene, static_cast<float>(i) / 1000, 0.37f)).x);
        });
        return found;
    };
    EXPECT_EQ(answers(1), answers(4));
}

TEST(AdaptiveMap, BacksOfSingleSidedSurfacesAreDark) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 64);
    const auto sums = sums_of(texels, Vec3(0, 0, 1), [](float, float) { return 100; });
    const AdaptiveMap map = map_of(sums, texels, 0.1, true);
    EXPECT_GT(map.irradiance(point_at(scene, 0.5f, 0.4f)).x, 0);
    EXPECT_EQ(map.irradiance(common::surface_point_at(scene, on_quad(0, 0.5f, 0.4f), {0, 0, 1})).x, 0);
}

TEST(AdaptiveMap, OfNoHitsIsDark) {
    const Scene scene = floor_of(plain);
    const PreparedTexels texels = texels_of(scene, 64);
    const shlm::TexelSums<AdaptiveModel> sums(texels.geometry.size(), shlm::Quantum(Rgb(1, 1, 1)));
    const AdaptiveMap map = map_of(sums, texels, 0.1, true);
    EXPECT_EQ(count_of(map, BlockKind::dark), 1u);
    EXPECT_EQ(map.estimated_error(), 0);
    EXPECT_EQ(map.irradiance(point_at(scene, 0.5f, 0.4f)), Rgb(0, 0, 0));
}

}  // namespace
