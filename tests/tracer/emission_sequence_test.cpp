// Tests how evenly a scrambled Sobol' sequence of emission spreads photons, and that a run stays the same
// however it is cut.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

#include "common/core/random.h"
#include "common/core/scrambled_sobol.h"
#include "common/tracer/recording_sink.h"
#include "tests/support/statistics.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::EmissionSequence;

constexpr int side = 16;  // texels of the floor below the light, which is 2 wide and 1 away

using Counts = std::array<double, side * side>;

/// Adds the photon to the texel that it meets.
void add(Counts& counts, const Vec3& origin, const Vec3& direction) {
    if (direction.z >= 0) return;
    const Vec3 at = origin - direction * (origin.z / direction.z);
    const auto texel = [](float x) { return static_cast<int>(std::floor((x + 1) / 2 * side)); };
    const int column = texel(at.x), row = texel(at.y);
    if (column >= 0 && column < side && row >= 0 && row < side)
        ++counts[static_cast<std::size_t>(row * side + column)];
}

/// Makes the counts of a run with this seed.
using Run = std::function<Counts(std::uint64_t seed, std::uint64_t photons)>;

/// The index of dispersion of the texels' counts over independent runs, variance / mean: 1 for independent
/// photons. And the mean count.
struct Dispersion {
    Sample index;  ///< one value for each texel
    double hits_per_texel = 0;
};

Dispersion dispersion_of(const Run& run, std::uint64_t photons) {
    constexpr std::uint64_t runs = count_for(32, 8);
    std::array<Sample, side * side> texels;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
        const Counts counts = run(seed, photons);
        for (std::size_t i = 0; i < counts.size(); ++i) texels[i].add(counts[i]);
    }
    Dispersion dispersion;
    for (const Sample& texel : texels) {
        dispersion.index.add(texel.variance() / texel.mean());
        dispersion.hits_per_texel += texel.mean() / (side * side);
    }
    return dispersion;
}

/// Returns the runs of a light as PhotonSource spreads them.
Run emitted(const Scene& scene, EmissionSequence sequence) {
    const auto rays = std::make_shared<common::RayScene>(scene);
    const auto source = std::make_shared<common::PhotonSource>(*rays, sequence);
    return [rays, source](std::uint64_t seed, std::uint64_t photons) {
        Counts counts{};
        common::PhotonBatch batch;
        batch.resize(common::photons_per_block);
        for (std::uint64_t first = 0; first < photons; first += batch.size()) {
            source->emit(seed, first, 0, batch);
            for (std::size_t i = 0; i < batch.size(); ++i)
                add(counts, Vec3(batch.origin[i]), Vec3(batch.direction[i]));
        }
        return counts;
    };
}

Scene floor_only() {
    Scene scene;
    add(scene, quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), diffuse(Rgb(0, 0, 0)));
    return scene;
}

Scene below_a_point() {
    Scene scene = floor_only();
    scene.point_light.push_back({{0.1f, 0.2f, 1}, Rgb(1, 1, 1), "point"});
    return scene;
}

constexpr float panel_side = 0.6f;

Scene below_a_panel() {
    Scene scene = floor_only();
    add(scene, quad({-0.3f, -0.3f, 1}, {0, panel_side, 0}, {panel_side, 0, 0}),
        diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)));
    return scene;
}

/// The planted fault: places and directions are pairs that are spread evenly each, but not together, as they
/// are paired at random.
Counts padded_pairs(std::uint64_t seed, std::uint64_t photons) {
    const auto keys = [&](std::uint32_t part) {
        const auto a = common::random_bits(seed, part, 0, common::RandomPurpose::scramble_of_origin);
        return std::array<std::uint32_t, common::sobol_dimensions>{a[0], a[1], 0, 0, 0, 0};
    };
    std::vector<std::uint32_t> order(photons);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), std::mt19937(static_cast<unsigned>(seed)));
    Counts counts{};
    for (std::uint32_t i = 0; i < photons; ++i) {
        const std::uint32_t other = order[i];
        const common::ScrambledSobol place(i, keys(1)), way(other, keys(2));
        const std::uint32_t a = i % 64, b = other % 64;
        const Vec3 origin(panel_side * (place.uniform(0, a) - 0.5f),
                          panel_side * (place.uniform(1, a) - 0.5f), 1);
        const Vec3 up = common::sample_cosine_hemisphere(way.uniform(0, b), way.uniform(1, b));
        add(counts, origin, -up);
    }
    return counts;
}

/// Returns the exponent of the index of dispersion between two numbers of photons, and its standard error.
struct Exponent {
    double value, error;
};

Exponent exponent_of(const Run& run) {
    const Dispersion few = dispersion_of(run, 1 << 13), many = dispersion_of(run, 1 << 17);
    const double span = std::log(many.hits_per_texel / few.hits_per_texel);
    testing::Test::RecordProperty("few_hits_per_texel", std::to_string(few.hits_per_texel));
    testing::Test::RecordProperty("few_index", std::to_string(few.index.mean()));
    testing::Test::RecordProperty("many_hits_per_texel", std::to_string(many.hits_per_texel));
    testing::Test::RecordProperty("many_index", std::to_string(many.index.mean()));
    return {std::log(many.index.mean() / few.index.mean()) / span,
            std::hypot(few.index.standard_error() / few.index.mean(),
                       many.index.standard_error() / many.index.mean()) /
                span};
}

/// The theory is that of many hits; a tenth is allowed beside the statistical error. Texels of a run are not
/// quite independent, so the bound is at five standard errors.
void expect_exponent(const Exponent& found, double theory) {
    EXPECT_NEAR(found.value, theory, 0.1 + 5 * found.error);
}

/// Stratified numbers miscount only the cells that the edges of a texel cut: n^(1 - 1/d) of n in d
/// dimensions.
TEST(EmissionSequence, SpreadsPointLightsAsTheSquareRootOfHits) {
    expect_exponent(exponent_of(emitted(below_a_point(), EmissionSequence::sobol)), -0.5);
}

TEST(EmissionSequence, SpreadsAreaLightsAsTheFourthRootOfHits) {
    expect_exponent(exponent_of(emitted(below_a_panel(), EmissionSequence::sobol)), -0.25);
}

TEST(EmissionSequence, IsIndependentWhereItIsRandom) {
    for (const Scene& scene : {below_a_point(), below_a_panel()}) {
        const Dispersion found = dispersion_of(emitted(scene, EmissionSequence::random), 1 << 13);
        EXPECT_NEAR(found.index.mean(), 1, 5 * found.index.standard_error());
    }
}

TEST(EmissionSequence, PairsThatAreNotSpreadTogetherAreFound) {
    const Exponent found = exponent_of(padded_pairs);
    EXPECT_GT(found.value, -0.25 + 0.1 + 5 * found.error);
}

TEST(EmissionSequence, IsTheSameForAnyNumberOfThreadsAndPieces) {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    add(scene, quad({-0.4f, -0.4f, 0.9f}, {0, 0.8f, 0}, {0.8f, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(3, 2, 1)));
    const common::RayScene rays(scene);
    const common::PhotonSource source(rays, EmissionSequence::sobol);
    const auto run = [&](int threads, std::initializer_list<std::uint64_t> ends) {
        common::ThreadPool pool(threads);
        common::RecordingSink sink;
        pool.run([&] {
            std::uint64_t first = 0;
            for (const std::uint64_t end : ends) {
                (void)common::trace_photons(rays, source, 1, {.photons = end - first, .first_photon = first},
                                            sink);
                first = end;
            }
        });
        return sink.hits();
    };
    const common::HitBatch once = run(1, {20'000});
    EXPECT_TRUE(same_hits(once, run(3, {20'000})));
    EXPECT_TRUE(same_hits(once, run(2, {4096, 3 * 4096, 20'000})));
    for (const std::uint64_t index : {0ull, 77ull, (1ull << 33) + 5}) {
        common::PhotonBatch batch;
        batch.resize(3);
        source.emit(1, index, 0, batch);
        EXPECT_EQ(Vec3(batch.direction[2]), source.emit(1, index + 2).direction);
    }
}

}  // namespace
