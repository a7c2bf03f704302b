#include "photonmap/photon_map.h"

#include <gtest/gtest.h>

#include <random>

#include "common/point_index/flann_index.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::HitBatch;
using photonmap::GatherSettings;
using photonmap::Kernel;
using photonmap::NearestPhotons;
using photonmap::PhotonMap;
using photonmap::PhotonStorage;

constexpr double degrees = pi / 180;
const Vec3 down(0, 0, -1);
const Rgb white(1, 1, 1);

/// A double-sided floor at z = 0 (triangles 0, 1), a wall at x = 0 (2, 3), and slopes that rise from x = 0 by
/// 45 (4, 5) and 75 degrees (6, 7).
const Scene& corner() {
    static const Scene made = [] {
        Scene scene;
        add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), double_sided(diffuse(white)));
        add(scene, quad({0, -1, 0}, {0, 2, 0}, {0, 0, 1}), diffuse(white));
        for (const double angle : {45 * degrees, 75 * degrees})
            add(scene,
                quad({0, -1, 0},
                     {static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))},
                     {0, 2, 0}),
                diffuse(white));
        return scene;
    }();
    return made;
}

PhotonMap<common::FlannIndex> map_of(const HitBatch& hits, GatherSettings settings) {
    PhotonStorage storage;
    storage.append(std::span(&hits, 1));
    common::FlannIndex index(storage.positions());
    return {corner(), {std::move(storage), std::move(index)}, 1, settings};
}

GatherSettings nearest(std::size_t k, float max_radius, Kernel kernel = Kernel::disc) {
    return {NearestPhotons{k}, kernel, max_radius};
}

/// Returns a point of the floor, seen from above.
common::SurfacePoint on_floor(const Vec3& position) {
    return {{0, 0, 0}, position, {0, 0, 1}, {0, 0, 1}, true};
}

/// Makes photons of flux 1 that arrive vertically on the floor's square (0, 1)^2: a Poisson process.
HitBatch poisson_photons(double density, std::mt19937_64& engine) {
    std::poisson_distribution<int> poisson(density);
    std::uniform_real_distribution<float> uniform(0, 1);
    HitBatch hits;
    for (int left = poisson(engine); left > 0; --left) {
        const float x = uniform(engine), y = uniform(engine);
        hits.push_back({x, y, 0}, down, white, {0, 0, 0});
    }
    return hits;
}

/// Returns relative estimates at points whose gathers do not overlap: on a grid, several gather radii apart
/// and away from the square's border.
std::vector<double> estimates(std::size_t k, Kernel kernel, double max_radius_photons, std::uint64_t seed) {
    constexpr int side = 24, rounds = static_cast<int>(count_for(3, 1));
    // Discs of k photons have 1 / 16 of a grid cell's area on average; those of 10 k photons still fit into
    // one cell.
    const double density = 16.0 * static_cast<double>(k) * side * side;
    const double max_radius = std::sqrt(max_radius_photons / (pi * density));
    std::mt19937_64 engine(seed);
    std::vector<double> relative;
    for (int round = 0; round < rounds; ++round) {
        const auto map =
            map_of(poisson_photons(density, engine), nearest(k, static_cast<float>(max_radius), kernel));
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const Vec3 at((static_cast<float>(i) + 0.5f) / side, (static_cast<float>(j) + 0.5f) / side,
                              0);
                relative.push_back(map.irradiance(on_floor(at)).x / density);
            }
    }
    return relative;
}

Sample sample_of(const std::vector<double>& values) {
    Sample sample;
    for (double value : values) sample.add(value);
    return sample;
}

TEST(PhotonMap, IsUnbiasedWithKMinusOneInTheNumerator) {
    constexpr std::uint64_t seed = 1;
    for (const std::size_t k : {3, 10, 50}) {
        // The area of the k-th photon's disc follows a gamma distribution of shape k. So (k - 1) / area has
        // the mean 1 and the variance 1 / (k - 2).
        const Sample sample = sample_of(estimates(k, Kernel::disc, 10.0 * static_cast<double>(k), seed));
        const double error = std::sqrt(1 / static_cast<double>(k - 2) / static_cast<double>(sample.count()));
        EXPECT_NEAR(sample.mean(), 1, z_for(3e-5) * error) << "k " << k << ", seed " << seed;
    }
}

TEST(PhotonMap, HasTheNoiseOfKMinusTwoPhotons) {
    constexpr std::uint64_t seed = 2;
    constexpr std::size_t k = 50;
    const Sample sample = sample_of(estimates(k, Kernel::disc, 500, seed));
    // The moments of (k - 1) / X, X gamma distributed with shape k, are (k - 1)^n / ((k - 1) ... (k - n)).
    const double m = k - 1, m2 = m / (k - 2), m3 = m2 * m / (k - 3), m4 = m3 * m / (k - 4);
    const double variance = m2 - 1, fourth = m4 - 4 * m3 + 6 * m2 - 3;
    EXPECT_NEAR(variance, 1.0 / (k - 2), 1e-12);
    const double error = std::sqrt((fourth - variance * variance) / static_cast<double>(sample.count()));
    EXPECT_NEAR(sample.variance(), variance, z_for(1e-4) * error) << "seed " << seed;
}

TEST(PhotonMap, EstimatesFollowTheGammaLaw) {
    constexpr std::uint64_t seed = 3;
    constexpr std::size_t k = 10, bins = 33;
    const std::vector<double> values = estimates(k, Kernel::disc, 100, seed);
    std::array<std::uint64_t, bins> counts{};
    for (const double value : values) {
        // The expected photons in the disc, and the probability of at most that many, which is that of at
        // least k events.
        const double in_disc = (k - 1) / value;
        const double probability = 1 - chi_square_tail(2 * in_disc, 2 * k);
        ++counts[std::min(static_cast<std::size_t>(probability * bins), bins - 1)];
    }
    const std::vector<double> expected(bins, static_cast<double>(values.size()) / bins);
    EXPECT_GT(chi_square_tail(chi_square(counts, expected), bins - 1), 1e-4) << "seed " << seed;
}

TEST(PhotonMap, IsUnbiasedWhetherOrNotItFindsKPhotons) {
    // If about as many photons are within max_radius as are asked for, half of the gathers use one rule and
    // half the other. The former contribute density * P(at least k - 1), the latter density * P(at most k -
    // 2).
    constexpr std::uint64_t seed = 4;
    const Sample sample = sample_of(estimates(10, Kernel::disc, 10, seed));
    EXPECT_NEAR(sample.mean(), 1, z_for(1e-4) * sample.standard_error()) << "seed " << seed;
}

TEST(PhotonMap, KernelsAreUnbiased) {
    constexpr std::uint64_t seed = 5;
    for (const Kernel kernel : {Kernel::cone, Kernel::epanechnikov}) {
        const Sample sample = sample_of(estimates(30, kernel, 300, seed));
        EXPECT_NEAR(sample.mean(), 1, z_for(3e-5) * sample.standard_error())
            << "kernel " << static_cast<int>(kernel) << ", seed " << seed;
    }
}

TEST(Kernel, HasTheMeanOneOverTheDisc) {
    constexpr int steps = 100'000;  // over d^2, in which the disc's area is uniform
    for (const Kernel kernel : {Kernel::disc, Kernel::cone, Kernel::epanechnikov}) {
        double sum = 0;
        photonmap::with_kernel(kernel, [&](auto weight) {
            for (int i = 0; i < steps; ++i) sum += weight(static_cast<float>((i + 0.5) / steps));
            EXPECT_EQ(weight(1), kernel == Kernel::disc ? 1 : 0) << "at the edge";
        });
        EXPECT_NEAR(sum / steps, 1, 1e-5) << static_cast<int>(kernel);
    }
}

/// Makes photons at these distances from the origin, on the floor.
HitBatch photons_at(const std::vector<float>& distances, const Vec3& direction = down,
                    std::uint32_t triangle = 0) {
    HitBatch hits;
    for (float d : distances) hits.push_back({0, d, 0}, direction, Rgb(1, 2, 3), {triangle, 0, 0});
    return hits;
}

void append(HitBatch& to, const HitBatch& from) {
    for (std::size_t i = 0; i < from.size(); ++i)
        to.push_back(from.position[i], from.direction[i], from.flux[i], from.surface[i]);
}

void expect_per_area(const Rgb& irradiance, double photons, double radius) {
    const double expected = photons / (pi * radius * radius);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(irradiance[c], expected * (c + 1), 3e-5 * expected * (c + 1)) << "channel " << c;
}

TEST(PhotonMap, UsesMaxRadiusWhereThereAreFewerThanK) {
    const auto map = map_of(photons_at({0.1f, 0.2f, 0.3f, 0.6f}), nearest(4, 0.5f));
    expect_per_area(map.irradiance(on_floor({0, 0, 0})), 3, 0.5);
    EXPECT_EQ(map.irradiance(on_floor({-0.9f, -0.9f, 0})), Rgb(0, 0, 0)) << "nothing near";
    EXPECT_EQ(map_of({}, nearest(4, 0.5f)).irradiance(on_floor({0, 0, 0})), Rgb(0, 0, 0)) << "an empty map";
}

TEST(PhotonMap, UsesTheKthPhotonsDistance) {
    const HitBatch hits = photons_at({0.1f, 0.2f, 0.3f, 0.4f});
    expect_per_area(map_of(hits, nearest(4, 0.5f)).irradiance(on_floor({0, 0, 0})), 3, 0.4);
    expect_per_area(map_of(hits, nearest(3, 0.5f)).irradiance(on_floor({0, 0, 0})), 2, 0.3);
    expect_per_area(map_of(hits, nearest(2, 0.5f)).irradiance(on_floor({0, 0, 0})), 1, 0.2);
}

TEST(PhotonMap, WeighsByTheConeKernel) {
    const auto map = map_of(photons_at({0.1f, 0.3f, 0.4f}), nearest(3, 0.5f, Kernel::cone));
    expect_per_area(map.irradiance(on_floor({0, 0, 0})), 3 * (1 - 0.25 + 1 - 0.75), 0.4);
}

TEST(PhotonMap, TakesAllPhotonsWithinAFixedRadius) {
    const double radius = 0.25;
    const GatherSettings settings{photonmap::FixedRadius{radius / corner().diagonal()}, Kernel::disc, 0};
    const auto map = map_of(photons_at({0.1f, 0.2f, 0.24f, 0.26f, 0.6f}), settings);
    expect_per_area(map.irradiance(on_floor({0, 0, 0})), 3, radius);
    EXPECT_EQ(map.irradiance(on_floor({-0.9f, -0.9f, 0})), Rgb(0, 0, 0)) << "nothing near";
    const auto smooth = map.with_gather({settings.selection, Kernel::epanechnikov, 0});
    const double weight = 2 * (3 - (0.01 + 0.04 + 0.0576) / (radius * radius));
    expect_per_area(smooth.irradiance(on_floor({0, 0, 0})), weight, radius);
}

TEST(PhotonMap, AddsUpManyEqualPhotons) {
    // Each add could round by half a unit of a float's last place; float sums are wrong by 1 part in 300.
    constexpr std::size_t count = 300'000;
    constexpr float flux = 1.3e-6f;
    HitBatch hits;
    for (std::size_t i = 0; i < count; ++i)
        hits.push_back({0, 0, 0}, down, {flux, 2 * flux, 3 * flux}, {0, 0, 0});
    const double radius = 0.01, expected = count * double{flux} / (pi * radius * radius);
    const auto map = map_of(hits, {photonmap::FixedRadius{radius / corner().diagonal()}});
    const Rgb read = map.irradiance(on_floor({0, 0, 0}));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(read[c] / ((c + 1) * expected), 1, 1e-6);
}

TEST(PhotonMap, NumberOfNearestGrowsWithThePhotons) {
    const GatherSettings settings{photonmap::GrowingNumber{0.1}, Kernel::disc, 0.5f};
    EXPECT_EQ(map_of(photons_at(std::vector<float>(27'000, 0.1f)), settings).nearest(), 90u);
    EXPECT_EQ(map_of(photons_at({0.1f}), settings).nearest(), 2u) << "one photon has no density";
}

TEST(PhotonStorage, SortingKeepsEveryPhotonWithItsPosition) {
    std::mt19937_64 engine(1);
    HitBatch hits = poisson_photons(5000, engine);
    for (std::size_t i = 0; i < hits.size(); ++i) hits.flux[i] = Rgb(hits.position[i]);
    PhotonStorage storage;
    storage.append(std::span(&hits, 1));
    const PhotonStorage sorted = std::move(storage).sorted_along_curve();
    ASSERT_EQ(sorted.size(), hits.size());
    double step = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        EXPECT_EQ(Vec3(sorted[i].flux), sorted.positions()[i]);
        if (i > 0) step += (sorted.positions()[i] - sorted.positions()[i - 1]).length();
    }
    // In random order, the mean step across the unit square would be 0.52.
    EXPECT_LT(step / static_cast<double>(sorted.size()), 0.05);
    const auto less = [](const Vec3& a, const Vec3& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
    std::vector<Vec3> before = hits.position, after(sorted.positions().begin(), sorted.positions().end());
    std::sort(before.begin(), before.end(), less);
    std::sort(after.begin(), after.end(), less);
    EXPECT_EQ(before, after);
}

TEST(PhotonMap, LeavesOutPhotonsOfOtherSurfaces) {
    const HitBatch counted = photons_at({0.3f, 0.4f});
    const Vec3 up(0, 0, 1), sideways(-1, 0, -1);
    for (const auto& [what, others] :
         {std::pair("from below", photons_at({0.01f, 0.02f, 0.03f}, up)),
          std::pair("on the wall", photons_at({0.01f, 0.02f, 0.03f}, sideways.normalized(), 2)),
          std::pair("on the steep slope", photons_at({0.01f, 0.02f, 0.03f}, down, 6))}) {
        HitBatch hits = others;
        append(hits, counted);
        expect_per_area(map_of(hits, nearest(2, 0.5f)).irradiance(on_floor({0, 0, 0})), 1, 0.4);
        EXPECT_EQ(map_of(others, nearest(2, 0.5f)).irradiance(on_floor({0, 0, 0})), Rgb(0, 0, 0)) << what;
    }
}

TEST(PhotonMap, BothSidesOfASheetHaveTheirOwnPhotons) {
    HitBatch hits = photons_at({0.1f, 0.2f});
    append(hits, photons_at({0.3f, 0.4f}, {0, 0, 1}));
    const auto map = map_of(hits, nearest(2, 0.5f));
    expect_per_area(map.irradiance(on_floor({0, 0, 0})), 1, 0.2);
    common::SurfacePoint below = on_floor({0, 0, 0});
    below.geometric_normal = below.shading_normal = -below.geometric_normal;
    below.front = false;
    expect_per_area(map.irradiance(below), 1, 0.4);
}

TEST(PhotonMap, TiltsEachPhotonByTheRatioOfItsCosines) {
    const double incident = 40 * degrees;
    const Vec3 direction(static_cast<float>(std::sin(incident)), 0, static_cast<float>(-std::cos(incident)));
    const auto map = map_of(photons_at({0.1f, 0.2f}, direction), nearest(2, 0.5f));
    for (const double tilt : {-70.0, -30.0, 0.0, 30.0, 49.0, 60.0, 80.0}) {
        common::SurfacePoint point = on_floor({0, 0, 0});
        point.shading_normal = {static_cast<float>(std::sin(tilt * degrees)), 0,
                                static_cast<float>(std::cos(tilt * degrees))};
        const double on_shading = std::max(0.0, std::cos(incident + tilt * degrees));
        expect_per_area(map.irradiance(point), on_shading / std::cos(incident), 0.2);
    }
}

TEST(PhotonMap, LimitsGrazingPhotons) {
    const Vec3 grazing = Vec3(1, 0, -1e-5f).normalized();
    common::SurfacePoint point = on_floor({0, 0, 0});
    point.shading_normal = Vec3(-1, 0, 1).normalized();
    const Rgb irradiance = map_of(photons_at({0.1f, 0.2f}, grazing), nearest(2, 0.5f)).irradiance(point);
    expect_per_area(irradiance, std::sqrt(0.5) / common::min_incident_cosine, 0.2);
}

TEST(PhotonMap, CoincidentPhotonsGiveAFiniteNumber) {
    for (const Kernel kernel : {Kernel::disc, Kernel::cone, Kernel::epanechnikov}) {
        const auto map = map_of(photons_at(std::vector<float>(500, 0.1f)), nearest(50, 0.5f, kernel));
        for (const float distance : {0.1f, 0.2f}) {
            const Rgb irradiance = map.irradiance(on_floor({0, distance, 0}));
            EXPECT_TRUE(common::is_finite(irradiance)) << irradiance;
            EXPECT_GE(irradiance.x, 0);
        }
    }
}

TEST(PhotonMap, CountsItsMemory) {
    const auto map = map_of(photons_at(std::vector<float>(100'000, 0.1f)), nearest(50, 0.5f));
    EXPECT_EQ(map.size(), 100'000u);
    EXPECT_GE(map.bytes(), 100'000 * (sizeof(Vec3) + sizeof(photonmap::Photon)));
}

}  // namespace
