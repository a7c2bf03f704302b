#include "shlm/basis/sh_basis.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/scene_builder.h"

namespace {

using namespace tests;
using shlm::evaluate_sh;

Vec3 random_direction(std::mt19937& engine) {
    std::uniform_real_distribution<float> uniform(0, 1);
    const float u = uniform(engine), v = uniform(engine);
    return common::sample_sphere(u, v);
}

/// Integrates with Simpson's rule, which is exact for polynomials up to the third degree and nearly exact
/// here.
template <class Function>
double integral(double low, double high, Function function) {
    constexpr int steps = 2000;  // even
    double sum = 0;
    for (int i = 0; i <= steps; ++i)
        sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * function(low + (high - low) * i / steps);
    return sum * (high - low) / steps / 3;
}

/// Returns the irradiance that the harmonics give a plane whose normal has the cosine x to a light of
/// perpendicular irradiance 1.
template <int Order>
double kernel(const Vec3& light, const Vec3& normal) {
    const auto a = evaluate_sh<Order>(light), b = evaluate_sh<Order>(normal);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double{shlm::cosine_factors<Order>[i]} * a[i] * b[i];
    return sum;
}

/// Returns max(0, x) = 1/4 + x/2 + 5/16 P2(x) - 3/32 P4(x) + ..., truncated after an order.
double closed_form(int order, double x) {
    const double xx = x * x;
    double sum = 0.25;
    if (order >= 1) sum += x / 2;
    if (order >= 2) sum += 5.0 / 16 * (3 * xx - 1) / 2;
    if (order >= 4) sum -= 3.0 / 32 * (35 * xx * xx - 30 * xx + 3) / 8;
    return sum;
}

TEST(ShBasis, IsOrthonormal) {
    constexpr std::size_t coefficient_count = shlm::harmonic_count(4);
    std::array<std::array<double, coefficient_count>, coefficient_count> products{};
    constexpr int z_steps = 512, turns = 16;
    for (int i = 0; i < z_steps; ++i)
        for (int j = 0; j < turns; ++j) {
            // Two Gauss points per step in z are exact for these polynomials, as are 16 azimuths.
            for (const double side : {-1.0, 1.0}) {
                const double z = -1 + (2 * i + 1 + side / std::sqrt(3.0)) / z_steps;
                const auto y = evaluate_sh<4>(common::direction_at(
                    static_cast<float>(z), static_cast<float>(j) / static_cast<float>(turns)));
                for (std::size_t a = 0; a < coefficient_count; ++a)
                    for (std::size_t b = 0; b < coefficient_count; ++b)
                        products[a][b] += double{y[a]} * y[b] * (4 * pi) / (2.0 * z_steps * turns);
            }
        }
    for (std::size_t a = 0; a < coefficient_count; ++a)
        for (std::size_t b = 0; b < coefficient_count; ++b)
            EXPECT_NEAR(products[a][b], a == b ? 1 : 0, 1e-6) << a << ", " << b;
}

TEST(ShBasis, HasTheDocumentedOrder) {
    const auto x = evaluate_sh<2>({1, 0, 0}), y = evaluate_sh<2>({0, 1, 0}), z = evaluate_sh<2>({0, 0, 1});
    const auto c1 = static_cast<float>(std::sqrt(3 / (4 * pi)));
    EXPECT_FLOAT_EQ(x[0], static_cast<float>(1 / std::sqrt(4 * pi)));
    EXPECT_FLOAT_EQ(y[1], c1);
    EXPECT_FLOAT_EQ(z[2], c1);
    EXPECT_FLOAT_EQ(x[3], c1);
    EXPECT_FLOAT_EQ(z[6], static_cast<float>(std::sqrt(5 / (4 * pi))));
    const float d = std::sqrt(0.5f);
    const float most =
        static_cast<float>(0.25 * std::sqrt(15 / pi));  // of the xy, yz, xz and x^2 - y^2 harmonics
    EXPECT_FLOAT_EQ(evaluate_sh<2>({d, d, 0})[4], most);
    EXPECT_FLOAT_EQ(evaluate_sh<2>({0, d, d})[5], most);
    EXPECT_FLOAT_EQ(evaluate_sh<2>({d, 0, d})[7], most);
    EXPECT_FLOAT_EQ(x[8], most);
    EXPECT_FLOAT_EQ(y[8], -most);
}

TEST(ShBasis, CosineFactorsAreTheLegendreCoefficientsOfTheClampedCosine) {
    const double a0 = 2 * pi * integral(0, 1, [](double x) { return x; });
    const double a1 = 2 * pi * integral(0, 1, [](double x) { return x * x; });
    const double a2 = 2 * pi * integral(0, 1, [](double x) { return x * (3 * x * x - 1) / 2; });
    EXPECT_NEAR(a0, pi, 1e-9);
    EXPECT_NEAR(a1, 2 * pi / 3, 1e-9);
    const double a3 = 2 * pi * integral(0, 1, [](double x) { return x * (5 * x * x - 3) * x / 2; });
    const double a4 =
        2 * pi * integral(0, 1, [](double x) { return x * (35 * x * x * x * x - 30 * x * x + 3) / 8; });
    EXPECT_NEAR(a2, pi / 4, 1e-9);
    EXPECT_NEAR(a3, 0, 1e-9) << "band 3 is left out";
    EXPECT_NEAR(a4, -pi / 24, 1e-9);
    for (std::size_t i = 0; i < shlm::harmonic_count(4); ++i)
        EXPECT_NEAR(shlm::cosine_factors<4>[i], i == 0 ? a0 : i < 4 ? a1 : i < 9 ? a2 : a4, 1e-6) << i;
}

TEST(ShBasis, OneLightGivesTheTruncatedKernel) {
    constexpr unsigned seed = 1;
    std::mt19937 engine(seed);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 light = random_direction(engine), normal = random_direction(engine);
        const double cosine = light.dot(normal);
        ASSERT_NEAR(kernel<0>(light, normal), closed_form(0, cosine), 1e-6) << "seed " << seed;
        ASSERT_NEAR(kernel<1>(light, normal), closed_form(1, cosine), 1e-6) << "seed " << seed;
        ASSERT_NEAR(kernel<2>(light, normal), closed_form(2, cosine), 1e-6) << "seed " << seed;
        ASSERT_NEAR(kernel<4>(light, normal), closed_form(4, cosine), 2e-6) << "seed " << seed;
    }
    EXPECT_NEAR(kernel<2>({0, 1, 0}, {0, 1, 0}), 1.0625, 1e-6);
    EXPECT_NEAR(kernel<2>({0, 1, 0}, {1, 0, 0}), 0.09375, 1e-6);
    EXPECT_NEAR(kernel<2>({0, 1, 0}, {0, -1, 0}), 0.0625, 1e-6);
    EXPECT_NEAR(kernel<1>({0, 1, 0}, {0, 1, 0}), 0.75, 1e-6);
    EXPECT_NEAR(kernel<4>({0, 1, 0}, {0, 1, 0}), 0.96875, 1e-6);
}

TEST(ShBasis, KeepsNearlyAllOfTheKernelsEnergy) {
    const double all = integral(0, 1, [](double x) { return x * x; });
    const double kept = integral(-1, 1, [](double x) { return closed_form(2, x) * closed_form(2, x); });
    EXPECT_NEAR(kept / all, 0.9921875, 1e-9);
    // The factors give the same: k = sum of (2 l + 1) / (4 pi) A_l P_l, and P_l^2 integrates to 2 / (2 l +
    // 1).
    double from_factors = 0;
    for (const double factor : shlm::cosine_factors<2>) from_factors += factor * factor;
    EXPECT_NEAR(from_factors / (8 * pi * pi) / all, 0.9921875, 1e-6);
}

TEST(ShBasis, IsTheSameHoweverTheWorldIsTurned) {
    constexpr unsigned seed = 2;
    std::mt19937 engine(seed);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 light = random_direction(engine), normal = random_direction(engine);
        Imath::M44f rotation;
        rotation.rotate(random_direction(engine) * 3.0f);
        Vec3 turned_light, turned_normal;
        rotation.multDirMatrix(light, turned_light);
        rotation.multDirMatrix(normal, turned_normal);
        ASSERT_NEAR(kernel<4>(light, normal), kernel<4>(turned_light, turned_normal), 4e-6)
            << "seed " << seed;
        const auto y = evaluate_sh<4>(light);  // each band's squares add up to (2 l + 1) / (4 pi)
        EXPECT_NEAR(y[1] * y[1] + y[2] * y[2] + y[3] * y[3], 3 / (4 * pi), 1e-6);
        EXPECT_NEAR(y[4] * y[4] + y[5] * y[5] + y[6] * y[6] + y[7] * y[7] + y[8] * y[8], 5 / (4 * pi), 1e-6);
        double band_4 = 0;
        for (std::size_t k = 9; k < y.size(); ++k) band_4 += double{y[k]} * y[k];
        EXPECT_NEAR(band_4, 9 / (4 * pi), 2e-6);
    }
}

}  // namespace
