// Tests the error of a texel's basis at tilted normals: the light, the truth it is compared with, and the
// answer of each basis.
#include <gtest/gtest.h>

#include "bench/experiments/bases/basis_error.h"
#include "bench/experiments/bases/basis_figures.h"
#include "bench/experiments/bases/directions.h"
#include "common/estimator/irradiance_estimator.h"
#include "tests/support/single_light.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using namespace bench::bases;
using common::Vec3;
using shlm::ShWeight;
using shlm::TexelModel;
using Words = std::vector<std::string>;

double surface_irradiance(const Environment& environment) {
    double sum = 0;
    for (const Arrival& arrival : environment) sum += arrival.irradiance;
    return sum;
}

// The light and the truth.

TEST(Directions, ShareTheCapEvenly) {
    for (const double least : {0.0, 0.5}) {
        Imath::V3d sum(0, 0, 0);
        double sum_zz = 0, sum_xx = 0, sum_xy = 0;
        const auto directions = directions_in_cap(2000, least);
        for (const Vec3& d : directions) {
            EXPECT_NEAR(d.length(), 1, 1e-6);
            EXPECT_GT(d.z, least);
            sum += Imath::V3d(d);
            sum_zz += d.z * d.z;
            sum_xx += d.x * d.x;
            sum_xy += d.x * d.y;
        }
        const auto count = static_cast<double>(directions.size());
        const double mean_zz = (1 + least + least * least) / 3;  // z is uniform from `least` to 1
        EXPECT_NEAR(sum.z / count, (1 + least) / 2, 1e-6);
        EXPECT_NEAR(sum_zz / count, mean_zz, 1e-6);
        EXPECT_NEAR(sum.x / count, 0, 1e-3);
        EXPECT_NEAR(sum.y / count, 0, 1e-3);
        EXPECT_NEAR(sum_xx / count, (1 - mean_zz) / 2, 1e-3);
        EXPECT_NEAR(sum_xy / count, 0, 1e-3);
    }
}

TEST(Environments, PointLightsHaveTheWholeRangeWhateverTheSeed) {
    const double horizon = std::sin(10 * pi / 180);
    for (const std::uint64_t seed : {1, 2})
        for (std::uint32_t i = 0; i < 50; ++i) {
            const Environment light = make_environment(LightKind::point, i, 50, seed);
            ASSERT_EQ(light.size(), 1u);
            EXPECT_NEAR(light[0].towards_light.length(), 1, 1e-6);
            EXPECT_GE(light[0].towards_light.z, horizon + (1 - horizon) * i / 50 - 1e-6);
            EXPECT_LE(light[0].towards_light.z, horizon + (1 - horizon) * (i + 1) / 50 + 1e-6);
            EXPECT_NEAR(light[0].irradiance, light[0].towards_light.z, 1e-6);
        }
}

TEST(Environments, RoomsAreLobesOverAFloor) {
    const double least = common::min_incident_cosine;
    for (std::uint32_t i = 0; i < 20; ++i) {
        const Environment room = make_environment(LightKind::room, i, 20, 1);
        const double share = cap_solid_angle(least) / static_cast<double>(room.size());
        double darkest = 1e30, brightest = 0;
        for (const Arrival& arrival : room) {
            const double radiance = arrival.irradiance / (arrival.towards_light.z * share);
            darkest = std::min(darkest, radiance);
            brightest = std::max(brightest, radiance);
        }
        EXPECT_GE(darkest, 0.1 - 1e-9);
        EXPECT_LE(brightest, 6.1);
        EXPECT_GT(brightest, 0.2) << "six lobes that together reach a tenth at most: chance below 1e-6";
    }
}

/// The expected radiance of the lobes is derived at the zenith w. For d uniform in the hemisphere around it,
/// the mean of (w.d)^s is 1 / (s + 1). For log s uniform from ln 2 to ln 32, the mean of 1 / (s + 1) is
/// (ln(32 / 33) - ln(2 / 3)) / ln 16.
TEST(Environments, RoomsHaveTheRadianceOfSixLobesOnAverage) {
    const auto count = static_cast<std::uint32_t>(count_for(4000, 400));
    const double expected = 0.1 + 6 * 0.5 * (std::log(32.0 / 33) - std::log(2.0 / 3)) / std::log(16.0);
    tests::Sample radiance;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Environment room = make_environment(LightKind::room, i, count, 1);
        const double share = cap_solid_angle(common::min_incident_cosine) / static_cast<double>(room.size());
        radiance.add(room.back().irradiance / (room.back().towards_light.z * share));
    }
    EXPECT_NEAR(radiance.mean(), expected, tests::z_for(1e-4) * radiance.standard_error());
}

TEST(Environments, AreTheSameForTheSameSeedAlone) {
    for (const LightKind kind : {LightKind::point, LightKind::room}) {
        const auto irradiance = [&](std::uint32_t index, std::uint64_t seed) {
            return surface_irradiance(make_environment(kind, index, 9, seed));
        };
        EXPECT_EQ(irradiance(3, 1), irradiance(3, 1));
        EXPECT_NE(irradiance(3, 1), irradiance(3, 2));
        EXPECT_NE(irradiance(3, 1), irradiance(4, 1));
    }
    EXPECT_EQ(environment_count(LightKind::uniform, 9), 1u);
    EXPECT_EQ(environment_count(LightKind::room, 9), 9u);
}

TEST(BasisError, TruthOfUniformLightIsTheViewFactor) {
    const Environment uniform = make_environment(LightKind::uniform, 0, 1, 1);
    const std::vector<Vec3> normals = {direction_in_xz(0), direction_in_xz(30), direction_in_xz(-60)};
    const std::vector<double> truth = true_irradiance(uniform, normals);
    // Light below the clamp of the cosine is missing: at most a belt of that height at full cosine.
    const double left_out = 2 * pi * common::min_incident_cosine;
    EXPECT_NEAR(truth[0], pi, left_out);
    EXPECT_NEAR(truth[1], pi * (1 + std::cos(30 * pi / 180)) / 2, left_out);
    EXPECT_NEAR(truth[2], pi * 0.75, left_out);
}

TEST(BasisError, IsRootMeanSquareOverMeanOfTheTruth) {
    const std::vector<double> truth = {1, 2, 3}, answers = {1, 4, 2};
    EXPECT_NEAR(relative_rms_percent(answers, truth), 100 * std::sqrt(5.0 / 3) / 2, 1e-9);
}

TEST(BasisError, NormalsFillTheCapOf60Degrees) {
    const std::vector<Vec3> normals = tilted_normals();
    ASSERT_EQ(normals.size(), 300u);
    double least = 1;
    for (const Vec3& normal : normals) least = std::min(least, double{normal.z});
    EXPECT_GT(least, 0.5);
    EXPECT_LT(least, 0.502);
}

// The bases.

TEST(OneTexel, IsOneTexelAndGetsTheIrradiance) {
    const OneTexel texel;
    ASSERT_EQ(texel.prepared().layout.texel_count(), 1u);
    EXPECT_NEAR(texel.prepared().geometry.front().area, 4, 1e-6);
    const auto photons = texel.photons_of(one_light(60));
    ASSERT_EQ(photons.size(), 1u);
    EXPECT_NEAR(photons.flux[0].x, 0.5 * 4, 1e-6);
    EXPECT_NEAR(photons.direction[0].x, -std::sin(60 * pi / 180), 1e-6);
}

template <int Order>
void expect_truncated_kernel() {
    const OneTexel texel;
    for (const double light : {0.0, 40.0, 80.0})
        for (const double tilt : {-60.0, -20.0, 0.0, 40.0, 60.0}) {
            const std::vector<Vec3> normal = {direction_in_xz(tilt)};
            const auto answers =
                ask<TexelModel<Order, ShWeight::radiance>>(texel, texel.photons_of(one_light(light)), normal);
            const double expected = truncated_kernel(Order, std::cos((tilt - light) * pi / 180));
            EXPECT_NEAR(answers.series[0], expected, 2e-6) << light << " " << tilt << ", order " << Order;
            EXPECT_NEAR(answers.answered[0], std::max(0.0, expected), 2e-6);
        }
}

TEST(Bases, OneLightGivesTheTruncatedKernel) {
    expect_truncated_kernel<0>();
    expect_truncated_kernel<1>();
    expect_truncated_kernel<2>();
    expect_truncated_kernel<4>();
}

TEST(Bases, NumbersAndBytesAreThoseOfTheStore) {
    std::vector<std::size_t> bytes;
    Words names;
    for (const Basis& basis : all_bases()) {
        names.push_back(basis.name);
        bytes.push_back(basis.bytes);
    }
    const Words ladder = {"L0/normalised", "F0/flux",     "AD/radiance", "YF1/radiance", "YF2/radiance",
                          "F1/radiance",   "L2/radiance", "F2/radiance", "L4/radiance"};
    Words expected = ladder;
    expected.insert(expected.end(), {"L2/normalised", "L2/flux"});
    for (const std::string& basis : ladder) expected.push_back(basis + "/half");
    EXPECT_EQ(names, expected);
    EXPECT_EQ(bytes, (std::vector<std::size_t>{12,  12, 24, 24, 44, 48, 108, 108, 216, 108,
                                               108, 6,  6,  12, 12, 22, 24,  54,  54,  108}));
}

}  // namespace
