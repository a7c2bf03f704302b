// Tests how much light a light map loses by clamping grazing hits.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/one_texel_floor.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::HitBatch;
using shlm::ClampedLight;
using shlm::PreparedTexels;
using shlm::ShWeight;

template <class Model>
ClampedLight clamped_by(const PreparedTexels& texels, std::span<const HitBatch> batches) {
    shlm::Accumulator<Model> accumulator(texels.layout, quantum_for(batches));
    accumulator.consume(batches);
    return accumulator.clamped();
}

template <class Model = shlm::PaperModel>
ClampedLight clamped_by(const HitBatch& hits) {
    return clamped_by<Model>(texels_of(floor_scene(), 1), std::span(&hits, 1));
}

/// The results of ClampedLight in W, and the tolerance for rounding of `hits` hits.
struct Watts {
    double flux, discarded, tolerance;
};

Watts in_watts(const ClampedLight& clamped, const HitBatch& hits) {
    const double unit = quantum_for(hits).clamped_light_unit();
    return {static_cast<double>(clamped.flux) * unit, static_cast<double>(clamped.discarded) * unit,
            0.51 * unit * static_cast<double>(hits.size())};
}

/// Returns a unit vector with exactly this cosine to the floor's normal.
Vec3 with_cosine(float cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

TEST(ClampedLight, IsTheShareBelowTheClamp) {
    constexpr double clamp = common::min_incident_cosine;
    HitBatch hits;
    double flux = 0, discarded = 0;
    for (const auto& [cosine, watts] :
         {std::pair(1.0f, 1.0f), std::pair(0.1f, 2.0f), std::pair(1.01e-3f, 4.0f), std::pair(7.5e-4f, 8.0f),
          std::pair(5e-4f, 16.0f), std::pair(1e-6f, 32.0f)}) {
        add_hit(hits, with_cosine(cosine), Rgb(0.5f, 1, 1.5f) * watts);
        flux += double{watts};
        discarded += double{watts} * std::max(0.0, 1 - cosine / clamp);
    }
    const ClampedLight clamped = clamped_by(hits);
    const Watts watts = in_watts(clamped, hits);
    EXPECT_NEAR(watts.flux, flux, watts.tolerance);
    EXPECT_NEAR(watts.discarded, discarded, watts.tolerance);
    EXPECT_EQ(clamped.discarded_share(), watts.discarded / watts.flux);
}

TEST(ClampedLight, IsWhatTheSurfaceLacks) {
    for (const float cosine : {0.5f, 9e-4f, 5e-4f, 1e-5f}) {
        const HitBatch hits = one_hit(with_cosine(cosine), Rgb(1, 1, 1));
        const double without_clamp = kernel(2, cosine) / cosine;
        const double share = clamped_by(hits).discarded_share();
        EXPECT_NEAR(Floor<shlm::PaperModel>(hits).irradiance(up).x / without_clamp, 1 - share, 1e-5)
            << "cosine " << cosine;
    }
}

TEST(ClampedLight, IsNothingWithoutGrazingHits) {
    EXPECT_EQ(clamped_by(HitBatch{}).discarded_share(), 0) << "not 0 / 0";
    HitBatch hits;
    for (const float cosine : {1.0f, 0.5f, 0.01f, common::min_incident_cosine})
        add_hit(hits, with_cosine(cosine), Rgb(1, 2, 3));
    const ClampedLight clamped = clamped_by(hits);
    EXPECT_EQ(clamped.discarded, 0u);
    EXPECT_NEAR(in_watts(clamped, hits).flux, 8, in_watts(clamped, hits).tolerance);
}

TEST(ClampedLight, IsNothingWhereTheSurfacesIrradianceDoesNotNeedTheCosine) {
    const HitBatch hits = one_hit(with_cosine(1e-5f), Rgb(1, 1, 1));
    for_each_order<ShWeight::radiance>(
        [&](auto model) { EXPECT_NEAR(clamped_by<decltype(model)>(hits).discarded_share(), 0.99, 1e-6); });
    for_each_order<ShWeight::flux>(
        [&](auto model) { EXPECT_EQ(clamped_by<decltype(model)>(hits).discarded_share(), 0); });
    // The sum that it keeps beside the shape is exact.
    for_each_order<ShWeight::normalised>([&](auto model) {
        EXPECT_EQ(clamped_by<decltype(model)>(hits).discarded_share(), 0) << model.order;
    });
}

TEST(ClampedLight, LeavesOutRejectedHits) {
    HitBatch hits = one_hit(with_cosine(5e-4f), Rgb(1, 1, 1));
    add_hit(hits, with_cosine(-1e-5f), Rgb(7, 7, 7));  // on the back
    add_hit(hits, with_cosine(1e-5f), Rgb(7, 7, std::numeric_limits<float>::infinity()));
    const ClampedLight clamped = clamped_by(hits);
    const Watts watts = in_watts(clamped, hits);
    EXPECT_NEAR(watts.flux, 1, watts.tolerance);
    EXPECT_NEAR(watts.discarded, 0.5, watts.tolerance);
}

/// Returns a room's hits, every seventh of which is rotated until it grazes its surface.
HitBatch hits_with_grazing_ones(const Scene& room, std::uint64_t seed) {
    HitBatch hits = record(room, seed, {.photons = count_for(100'000, 20'000)}).hits;
    for (std::size_t i = 0; i < hits.size(); i += 7) {
        const common::Frame frame(room.geometric_normal[hits.surface[i].triangle]);
        const float part = static_cast<float>(i) / static_cast<float>(hits.size());
        hits.direction[i] =
            -frame.to_world(common::direction_at(2 * common::min_incident_cosine * part, part));
    }
    return hits;
}

TEST(ClampedLight, IsTheSameOnAnyNumberOfThreadsAndForAnyWaves) {
    constexpr std::uint64_t seed = 2;
    Scene room = closed_box(diffuse(Rgb(0.7f, 0.5f, 0.3f)));
    add(room, quad({-0.5f, -0.5f, -0.5f}, {1, 0, 0}, {0, 1, 0}),
        double_sided(diffuse(Rgb(0.5f, 0.5f, 0.5f))));
    room.point_light.push_back({{0, 0, 0.2f}, Rgb(3, 2, 1)});
    const PreparedTexels texels = texels_of(room, 500);
    const std::vector<HitBatch> batches = in_batches(hits_with_grazing_ones(room, seed), 1000);
    using Accumulator = shlm::Accumulator<shlm::PaperModel>;
    Accumulator reference(texels.layout, quantum_for(room));
    common::ThreadPool(1).run([&] { reference.consume(batches); });
    EXPECT_GT(reference.clamped().discarded_share(), 0.01) << "seed " << seed;
    for (const int threads : {1, 2, 7})
        for (const std::size_t wave : {std::size_t{1}, std::size_t{3}, std::size_t{64}}) {
            Accumulator other(texels.layout, quantum_for(room));
            common::ThreadPool(threads).run([&] {
                for (std::size_t i = 0; i < batches.size(); i += wave)
                    other.consume(std::span(batches).subspan(i, std::min(wave, batches.size() - i)));
            });
            EXPECT_EQ(other.clamped().flux, reference.clamped().flux)
                << threads << " threads, waves of " << wave;
            EXPECT_EQ(other.clamped().discarded, reference.clamped().discarded)
                << threads << " threads, waves of " << wave;
        }
}

}  // namespace
