#include <gtest/gtest.h>

#include "common/tracer/recording_sink.h"
#include "common/tracer/rejected_hits.h"
#include "photonmap/photon_sinks.h"
#include "shlm/map/sink.h"
#include "tests/support/statistics.h"
#include "tests/support/texels.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::HitBatch;
using common::RejectedHits;
using photonmap::FlannIncrementalPhotonSink;
using photonmap::FlannPhotonSink;
using photonmap::PhotonStorage;

constexpr std::uint64_t photon_count = common::photons_per_block * count_for(120, 10);

Scene lit_box(const Rgb& albedo) {
    Scene scene = closed_box(diffuse(albedo));
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(3, 2, 1)});
    return scene;
}

constexpr std::size_t texels_wanted = 10'000;

/// The flux that each block of photons brings to the walls, W times the number emitted. Blocks are
/// independent, which gives the error.
struct BlockFlux {
    std::array<Sample, 3> channel;
    void consume(std::span<const HitBatch> wave) {
        for (const HitBatch& batch : wave)
            for (int c = 0; c < 3; ++c) {
                double sum = 0;
                for (const Rgb& flux : batch.flux) sum += flux[c];
                channel[static_cast<std::size_t>(c)].add(sum);
            }
    }
};

Imath::V3d flux_in(const PhotonStorage& storage) {
    Imath::V3d sum(0, 0, 0);
    for (std::size_t i = 0; i < storage.size(); ++i) sum += Imath::V3d(storage[i].flux);
    return sum;
}

using FluxModel = shlm::TexelModel<2, shlm::ShWeight::flux>;

/// Returns the flux from the first number of these sums, which is the flux times Y00.
Imath::V3d flux_in(const shlm::Accumulator<FluxModel>& accumulator) {
    Imath::V3d sum(0, 0, 0);
    for (std::size_t i = 0; i < accumulator.sums().size(); ++i) {
        const auto texel = accumulator.sums()[i];
        sum += Imath::V3d(texel.value[0], texel.value[1], texel.value[2]);
    }
    return sum * std::sqrt(4 * pi);
}

void expect_multiplied_power(const Rgb& albedo) {
    constexpr std::uint64_t seed = 1;
    const Scene scene = lit_box(albedo);
    const shlm::PreparedTexels texels = texels_of(scene, texels_wanted);
    PhotonStorage storage;
    struct StorageSink {
        PhotonStorage& storage;
        void consume(std::span<const HitBatch> wave) { storage.append(wave); }
    } photons{storage};
    shlm::Accumulator<FluxModel> accumulator(texels.layout, quantum_for(scene));
    BlockFlux blocks;
    Tee all(photons, accumulator, blocks);
    const common::TraceReport report = trace(scene, seed, {.photons = photon_count}, all);

    const Imath::V3d in_photons = flux_in(storage) * report.watts_per_flux();
    const Imath::V3d in_texels = flux_in(accumulator) * report.watts_per_flux();
    for (int c = 0; c < 3; ++c) {
        const double power = 4 * pi * scene.point_light[0].intensity[c];
        const double expected = power / (1 - albedo[c]);
        const double error =
            blocks.channel[static_cast<std::size_t>(c)].standard_error() / common::photons_per_block;
        EXPECT_NEAR(in_photons[c], expected, z_for(1e-5) * error + 1e-6 * expected)
            << "channel " << c << ", seed " << seed;
        EXPECT_NEAR(in_texels[c], in_photons[c], 1e-6 * expected) << "channel " << c;
    }
    EXPECT_EQ(storage.size(), report.hits);
    EXPECT_EQ(accumulator.rejected().total(), 0u);
}

TEST(Energy, ClosedBoxMultipliesThePowerByTheSeriesOfItsAlbedo) {
    expect_multiplied_power(Rgb(0.5f, 0.5f, 0.5f));
}

TEST(Energy, EveryChannelHasItsOwnAlbedo) {
    expect_multiplied_power(Rgb(0.8f, 0.5f, 0.2f));
}

TEST(Energy, BlackBoxKeepsThePower) {
    expect_multiplied_power(Rgb(0, 0, 0));
}

/// Makes a box with a wall that has no lightmap coordinates, and two plates inside, one of them single-sided
/// and one double-sided.
Scene room_with_trouble() {
    Scene scene;
    const auto walls = box_walls({-1, -1, -1}, {1, 1, 1});
    for (std::size_t i = 0; i < walls.size(); ++i) {
        Mesh wall = walls[i];
        if (i == 0) wall.texcoord = {};
        add(scene, wall, diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    }
    add(scene, quad({-0.5f, -0.5f, -0.5f}, {1, 0, 0}, {0, 1, 0}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    add(scene, quad({-0.5f, -0.5f, 0.5f}, {1, 0, 0}, {0, 1, 0}),
        double_sided(diffuse(Rgb(0.5f, 0.5f, 0.5f))));
    scene.point_light.push_back({{0, 0, 0}, Rgb(1, 1, 1)});
    return scene;
}

TEST(Energy, PhotonMapsStoreEveryHit) {
    const Scene scene = room_with_trouble();
    FlannPhotonSink bulk(scene, {.max_radius = 0.1f});
    FlannIncrementalPhotonSink incremental(scene, {.max_radius = 0.1f});
    Tee both(bulk, incremental);
    const common::TraceReport report = trace(scene, 2, {.photons = 20'000}, both);
    EXPECT_EQ(bulk.rejected().total(), 0u);
    EXPECT_EQ(incremental.rejected().total(), 0u);
    EXPECT_EQ(common::finish_map(std::move(bulk), report).size(), report.hits);
    EXPECT_EQ(common::finish_map(std::move(incremental), report).size(), report.hits);
}

TEST(Energy, LightMapCountsWhatItCannotStore) {
    const Scene scene = room_with_trouble();
    const shlm::PreparedTexels texels = texels_of(scene, texels_wanted);
    shlm::Sink<shlm::PaperModel> sink(texels, shlm::NearestTexels{}, quantum_for(scene));
    common::RecordingSink recorder;
    Tee both(sink, recorder);
    const common::TraceReport report = trace(scene, 3, {.photons = 20'000}, both);

    RejectedHits expected;
    for (std::size_t i = 0; i < recorder.hits().size(); ++i) {
        const std::uint32_t triangle = recorder.hits().surface[i].triangle;
        const std::uint32_t instance = scene.instance_of[triangle];
        if (instance == 0)
            ++expected.without_texel;
        else if (instance == 6 && recorder.hits().direction[i].dot(scene.geometric_normal[triangle]) > 0)
            ++expected.back_of_single_sided;
    }
    const RejectedHits rejected = sink.rejected();
    EXPECT_GT(rejected.without_texel, 0u);
    EXPECT_GT(rejected.back_of_single_sided, 0u);
    EXPECT_EQ(rejected.without_texel, expected.without_texel);
    EXPECT_EQ(rejected.back_of_single_sided, expected.back_of_single_sided);
    EXPECT_EQ(rejected.not_finite, 0u);
    std::uint64_t stored = 0;
    for (std::size_t i = 0; i < texels.geometry.size(); ++i)
        if (texels.geometry[i].area > 0) stored += sink.accumulator().sums()[i].hits;
    EXPECT_EQ(stored + rejected.total(), report.hits);
}

TEST(Energy, MirrorsAndGlassTakeNothingFromTheBalance) {
    // A mirror and a clear glass ball absorb nothing, so the walls get the same flux.
    constexpr std::uint64_t seed = 4;
    Scene scene = lit_box(Rgb(0.5f, 0.5f, 0.5f));
    add(scene, sphere({-0.5f, -0.5f, -0.5f}, 0.4f, 2), mirror());
    add(scene, sphere({0.5f, -0.5f, -0.5f}, 0.4f, 2), glass());
    BlockFlux blocks;
    trace(scene, seed, {.photons = photon_count}, blocks);
    const Sample& red = blocks.channel[0];
    EXPECT_NEAR(red.mean() / common::photons_per_block, 4 * pi * 3 * 2,
                z_for(1e-4) * red.standard_error() / common::photons_per_block)
        << "seed " << seed;
}

/// Makes one valid hit, and one for each way in which a hit can be invalid.
HitBatch broken_hits() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    const Vec3 at(0, 0, -1), down(0, 0, -1);
    const Rgb flux(1, 1, 1);
    const SurfaceId surface = on_quad(8, 0.6f, 0.4f);  // the wall at z = -1
    HitBatch batch;
    batch.push_back(at, down, flux, surface);
    batch.push_back(at, down, Rgb(nan, 1, 1), surface);
    batch.push_back(at, down, Rgb(1, inf, 1), surface);
    batch.push_back(at, down, Rgb(1, 1, -inf), surface);
    batch.push_back(at, Vec3(0, nan, -1), flux, surface);
    batch.push_back(at, Vec3(0, 0, -inf), flux, surface);
    batch.push_back(Vec3(nan, 0, -1), down, flux, surface);
    batch.push_back(Vec3(0, inf, -1), down, flux, surface);
    return batch;
}

template <class Sink>
void expect_only_the_good_hit(Sink sink) {
    const HitBatch hits = broken_hits();
    sink.consume(std::span(&hits, 1));
    EXPECT_EQ(sink.rejected().not_finite, hits.size() - 1);
    EXPECT_EQ(sink.rejected().total(), hits.size() - 1);
    const auto map = std::move(sink).finish(1);
    const Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    const Rgb irradiance = map.irradiance(front_of(scene, on_quad(8, 0.6f, 0.4f)));
    EXPECT_TRUE(common::is_finite(irradiance)) << irradiance;
    EXPECT_GT(irradiance.x, 0);
}

TEST(Energy, PhotonMapRejectsHitsThatAreNotFinite) {
    const Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    expect_only_the_good_hit(FlannPhotonSink(scene, {.max_radius = 0.5f}));
    expect_only_the_good_hit(FlannIncrementalPhotonSink(scene, {.max_radius = 0.5f}));
}

TEST(Energy, LightMapRejectsHitsThatAreNotFinite) {
    const Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    const shlm::PreparedTexels texels = texels_of(scene, 600);
    expect_only_the_good_hit(
        shlm::Sink<shlm::PaperModel>(texels, shlm::NearestTexels{}, quantum_for(broken_hits())));
}

}  // namespace
