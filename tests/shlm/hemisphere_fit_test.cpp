// Tests the least squares fit of radiance over the hemisphere against its definition and closed forms.
#include "shlm/basis/hemisphere_fit.h"

#include <gtest/gtest.h>

#include <random>

#include "common/core/sampling.h"
#include "shlm/basis/texel_model.h"

namespace {

using common::Rgb;
using common::Vec3;
using shlm::HemisphereFit;
using shlm::TexelLight;

constexpr double pi = std::numbers::pi;

Vec3 any_direction(std::mt19937& engine) {
    std::normal_distribution<float> normal;
    return Vec3(normal(engine), normal(engine), normal(engine)).normalized();
}

template <int Order>
double value(const shlm::DirectionPolynomial& polynomial, const Vec3& w) {
    const auto factors = polynomial.harmonics<Order>();
    const auto y = shlm::evaluate_sh<Order>(w);
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) sum += double{factors[i]} * y[i];
    return sum;
}

/// A hit of unit area, as seen in the frame of the surface.
struct Hit {
    Vec3 towards_light;  ///< world space
    float cosine;        ///< of incidence
    Rgb flux;
};

template <int Order, shlm::ShWeight Weight>
TexelLight<Order> light_of(std::span<const Hit> hits, const Vec3& surface_normal) {
    using Model = shlm::TexelModel<Order, Weight>;
    std::array<Imath::V3d, Model::summed> sum;
    sum.fill(Imath::V3d(0, 0, 0));
    for (const Hit& hit : hits) {
        const auto values = Model::of_hit(hit.towards_light, 1 / hit.cosine);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += Imath::V3d(hit.flux) * static_cast<double>(values[i]);
    }
    std::array<Rgb, Model::summed> mean;
    for (std::size_t i = 0; i < sum.size(); ++i) mean[i] = Rgb(sum[i]);
    return shlm::finished_light<Model>(mean, surface_normal);
}

template <int Order>
constexpr shlm::ShWeight right_weight = Order == 0 ? shlm::ShWeight::flux : shlm::ShWeight::radiance;

template <int Order>
Rgb irradiance(std::span<const Hit> hits, const Vec3& surface_normal, const Vec3& normal) {
    using Fit = HemisphereFit<Order>;
    const auto light = light_of<Order, right_weight<Order>>(hits, surface_normal);
    return Fit::irradiance(Fit::numbers_of(light, surface_normal), surface_normal,
                           typename Fit::Question(normal));
}

/// Returns hits of uniform radiance 1 / pi from directions that share the hemisphere evenly.
std::vector<Hit> uniform_light(const Vec3& surface_normal) {
    const common::Frame frame(surface_normal);
    std::vector<Hit> hits;
    constexpr int side = 200;
    for (int i = 0; i < side * side; ++i) {
        const double z = (i / side + 0.5) / side, turn = 2 * pi * (i % side + 0.5) / side;
        const double r = std::sqrt(1 - z * z);
        const Vec3 d(Imath::V3d(r * std::cos(turn), r * std::sin(turn), z));
        hits.push_back({frame.to_world(d), d.z, Rgb(1, 1, 1) * (2 * d.z / static_cast<float>(side * side))});
    }
    return hits;
}

/// The error of a least squares fit is orthogonal to all functions that were fitted.
template <int Order>
void expect_least_squares() {
    std::mt19937 engine(1);
    constexpr int rings = 400, sectors = 400;
    for (int trial = 0; trial < 10; ++trial) {
        const Vec3 surface_normal = any_direction(engine), normal = any_direction(engine);
        const common::Frame frame(surface_normal);
        const auto fit = shlm::fitted_clamped_cosine<Order>(surface_normal, normal);
        shlm::ShValues<Order> product{};
        for (int i = 0; i < rings * sectors; ++i) {
            const double z = (i / sectors + 0.5) / rings, turn = 2 * pi * (i % sectors + 0.5) / sectors;
            const double r = std::sqrt(1 - z * z);
            const Vec3 w =
                frame.to_world(Vec3(Imath::V3d(r * std::cos(turn), r * std::sin(turn), z))).normalized();
            const double error = value<Order>(fit, w) - std::max(w.dot(normal), 0.0f);
            const auto y = shlm::evaluate_sh<Order>(w);
            for (std::size_t k = 0; k < y.size(); ++k)
                product[k] += static_cast<float>(error * y[k] * 2 * pi / (rings * sectors));
        }
        for (const float one : product)
            EXPECT_NEAR(one, 0, 2e-5) << "the sum over " << rings * sectors << " directions is that accurate";
    }
}

TEST(FittedClampedCosine, IsTheLeastSquaresFitOverTheHemisphere) {
    expect_least_squares<1>();
    expect_least_squares<2>();
}

TEST(FittedClampedCosine, IsTheCosineForTheSurfacesOwnNormal) {
    std::mt19937 engine(2);
    for (int i = 0; i < 100; ++i) {
        const Vec3 n = any_direction(engine);
        const auto fit = shlm::fitted_clamped_cosine<2>(n, n);
        EXPECT_NEAR(fit.constant, 0, 1e-7);
        EXPECT_NEAR((fit.linear - n).length(), 0, 1e-7);
        for (const float quadratic : {fit.xx, fit.yy, fit.zz, fit.xy, fit.yz, fit.xz})
            EXPECT_NEAR(quadratic, 0, 1e-7);
    }
}

std::vector<Hit> any_light(std::mt19937& engine, const Vec3& surface_normal) {
    std::uniform_real_distribution<float> uniform(0, 1);
    const common::Frame frame(surface_normal);
    std::vector<Hit> hits(1 + engine() % 30);
    for (Hit& hit : hits) {
        Vec3 d = any_direction(engine);
        d.z = std::max(std::abs(d.z), 0.01f);
        d.normalize();
        const Vec3 towards_light = frame.to_world(d).normalized();
        hit = {towards_light, towards_light.dot(surface_normal), {uniform(engine), uniform(engine), 0.5f}};
    }
    return hits;
}

/// At the surface's own normal, the answer is the sum of the hits' flux, whatever the light.
template <int Order>
void expect_exact_at_own_normal() {
    std::mt19937 engine(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 n = any_direction(engine);
        const std::vector<Hit> hits = any_light(engine, n);
        Imath::V3d expected(0, 0, 0), radiance(0, 0, 0);
        for (const Hit& hit : hits) {
            expected += Imath::V3d(hit.flux);
            radiance += Imath::V3d(hit.flux) / hit.cosine;
        }
        const Rgb found = irradiance<Order>(hits, n, n);
        // The last bits of floats that are as large as the sum of radiance.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 4e-7 * radiance[c]) << "order " << Order;
    }
}

TEST(HemisphereFit, IsExactAtTheSurfacesOwnNormalForAnyLight) {
    expect_exact_at_own_normal<0>();
    expect_exact_at_own_normal<1>();
    expect_exact_at_own_normal<2>();
}

TEST(HemisphereFit, IsExactForUniformLightFromAbove) {
    std::mt19937 engine(4);
    for (int i = 0; i < 10; ++i) {
        const Vec3 n = any_direction(engine), normal = any_direction(engine);
        const std::vector<Hit> hits = uniform_light(n);
        const double expected = (1 + n.dot(normal)) / 2;
        EXPECT_NEAR(irradiance<0>(hits, n, normal).x, expected, 1e-4);
        EXPECT_NEAR(irradiance<1>(hits, n, normal).x, expected, 1e-4);
        EXPECT_NEAR(irradiance<2>(hits, n, normal).x, expected, 1e-4);
    }
}

/// Order 1: radiance a + b . w with the four moments of the hemisphere, and its integral with the clamped
/// cosine, which is pi a (1 + cos beta) / 2 + 2/3 ((pi - beta) b . n + b_z sin beta).
TEST(HemisphereFit, OfOrder1HasItsClosedForm) {
    std::mt19937 engine(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 up(0, 0, 1), normal = any_direction(engine);
        const std::vector<Hit> hits = any_light(engine, up);
        double m0 = 0;
        Imath::V3d m(0, 0, 0);
        for (const Hit& hit : hits) {
            const double radiance = double{hit.flux.x} / hit.cosine;
            m0 += radiance;
            m += Imath::V3d(hit.towards_light) * radiance;
        }
        const double a = (2 * m0 - 3 * m.z) / pi;
        const Imath::V3d b(3 * m.x / (2 * pi), 3 * m.y / (2 * pi), (6 * m.z - 3 * m0) / pi);
        const double beta = std::acos(std::clamp(double{normal.z}, -1.0, 1.0));
        const double expected = pi * a * (1 + std::cos(beta)) / 2 +
                                2.0 / 3 * ((pi - beta) * b.dot(Imath::V3d(normal)) + b.z * std::sin(beta));
        EXPECT_NEAR(irradiance<1>(hits, up, normal).x, expected, 3e-6 * m0);
    }
}

}  // namespace
