// Tests how a texel evaluates its hits, for every order and weight, against closed forms.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/one_texel_floor.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::HitBatch;
using shlm::ShWeight;
using shlm::TexelModel;

constexpr double degrees = pi / 180;

/// Besides the relative error, up to 18 numbers may each be rounded by 2^-24 of the light, which is about 1
/// here.
void expect_near(const Rgb& actual, const Rgb& expected, double relative, const std::string& what) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], relative * (std::abs(expected[c]) + 0.01) + 18 * 0x1p-24)
            << what << ", channel " << c;
}

/// Makes hits from everywhere above the floor, each colour from different directions: some straight down,
/// some grazing, some beyond the clamp.
HitBatch mixed_light(unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    HitBatch hits;
    for (int i = 0; i < 200; ++i) {
        const double cosine = std::pow(10, -6 * uniform(engine)), turn = 2 * pi * uniform(engine);
        Rgb flux(0, 0, 0);
        flux[i % 3] = static_cast<float>(uniform(engine));
        add_hit(hits, direction(std::acos(cosine), turn), flux);
    }
    add_hit(hits, up, Rgb(0, 0.5f, 0));
    return hits;
}

Rgb flux_of(const HitBatch& hits) {
    Imath::C3f sum(0, 0, 0);
    for (const Rgb& flux : hits.flux) sum += flux;
    return sum;
}

/// Returns normals all over the hemisphere, the surface's own first.
std::vector<Vec3> normals() {
    std::vector<Vec3> all = {up};
    for (const double tilt : {10, 30, 45, 60, 75, 89})
        for (const double turn : {0, 80, 160, 240, 320})
            all.push_back(direction(tilt * degrees, turn * degrees));
    return all;
}

std::string name_of(int order, const Vec3& normal) {
    return "order " + std::to_string(order) + ", normal " + std::to_string(normal.x) + " " +
           std::to_string(normal.y) + " " + std::to_string(normal.z);
}

// Tests of what is stored.

TEST(TexelModel, SumsAndHoldsAsManyNumbersAsItSays) {
    constexpr std::array<std::size_t, 5> harmonics = {1, 4, 9, 0, 18};
    for_each_model([&](auto model) {
        using Model = decltype(model);
        const std::size_t held = harmonics[static_cast<std::size_t>(Model::order)];
        const bool flat = Model::order == 0;  // the surface's irradiance alone
        EXPECT_EQ(Model::summed, Model::weight == ShWeight::normalised && !flat ? held + 1 : held);
        EXPECT_EQ(sizeof(shlm::TexelLight<Model::order>), held * sizeof(Rgb));
    });
}

TEST(TexelModel, ATraditionalLightMapStoresOneForEachHit) {
    using LightMapModel = TexelModel<0, ShWeight::normalised>;
    for (const float inverse_cosine : {1.0f, 2.0f, 1000.0f})
        EXPECT_EQ(LightMapModel::of_hit(direction(1.2), inverse_cosine), LightMapModel::Values{1});
    const auto light = shlm::finished_light<LightMapModel>({Rgb(1, 2, 3)}, up);
    expect_near(shlm::evaluate_series<0>(light, shlm::evaluate_sh<0>(direction(0.3))), Rgb(1, 2, 3), 1e-6,
                "its only number");
}

// Tests of what is answered.

TEST(TexelModel, ATraditionalLightMapGivesTheSurfacesIrradianceToEveryNormal) {
    constexpr unsigned seed = 1;
    const HitBatch hits = mixed_light(seed);
    const Floor<TexelModel<0, ShWeight::normalised>> floor(hits);
    for (const Vec3& normal : normals())
        expect_near(floor.irradiance(normal), flux_of(hits), 1e-5, name_of(0, normal));
}

TEST(TexelModel, NormalisedIsExactForTheSurfacesOwnNormal) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const HitBatch hits = mixed_light(seed);
        for_each_order<ShWeight::normalised>([&](auto model) {
            const Floor<decltype(model)> floor(hits);
            expect_near(floor.irradiance(up), flux_of(hits), 1e-5,
                        name_of(model.order, up) + ", seed " + std::to_string(seed));
        });
    }
    // A single grazing light.
    for (const double cosine : {0.5, 1e-2, 1e-3, 1e-5, 1e-7})
        for_each_order<ShWeight::normalised>([&](auto model) {
            const Floor<decltype(model)> floor(one_hit(direction(std::acos(cosine)), Rgb(1, 2, 3)));
            expect_near(floor.irradiance(up), Rgb(1, 2, 3), 1e-6, name_of(model.order, up));
        });
}

TEST(TexelModel, NormalisedFollowsTheHarmonicsElsewhere) {
    // Each channel has its own light.
    const std::array<Vec3, 3> lights = {direction(70 * degrees), direction(20 * degrees, 2),
                                        direction(89.99 * degrees, 4)};
    HitBatch hits;
    for (int c = 0; c < 3; ++c) {
        Rgb flux(0, 0, 0);
        flux[c] = static_cast<float>(c + 1);
        add_hit(hits, lights[static_cast<std::size_t>(c)], flux);
    }
    for_each_order<ShWeight::normalised>([&](auto model) {
        constexpr int order = decltype(model)::order;
        const Floor<decltype(model)> floor(hits);
        for (const Vec3& normal : normals()) {
            Rgb expected(0, 0, 0);
            for (int c = 0; c < 3; ++c) {
                const Vec3& light = lights[static_cast<std::size_t>(c)];
                expected[c] =
                    static_cast<float>((c + 1) * kernel(order, light.dot(normal)) / kernel(order, light.z));
            }
            expect_near(floor.irradiance(normal), expected, 1e-4, name_of(order, normal));
        }
    });
}

/// Returns what a texel with the normal `up` holds after one hit that brings 1 W/m^2 to a surface at that
/// cosine to the light.
template <class Model>
shlm::TexelLight<Model::order> held_after(const Vec3& light, double cosine) {
    std::array<Rgb, Model::summed> mean;
    const auto values = Model::of_hit(light, static_cast<float>(1 / cosine));
    for (std::size_t i = 0; i < Model::summed; ++i) mean[i] = Rgb(1, 1, 1) * values[i];
    return shlm::finished_light<Model>(mean, up);
}

template <int Order>
double largest_answer(const shlm::TexelLight<Order>& held) {
    using Basis = shlm::Harmonics<Order>;
    double largest = 0;
    for (int tilt = -90; tilt <= 90; ++tilt) {
        const typename Basis::Question question(direction(tilt * degrees));
        const Rgb answer = Basis::irradiance(Basis::numbers_of(held, up), up, question);
        largest = std::max(largest, static_cast<double>(answer.x));
    }
    return largest;
}

TEST(TexelModel, NormalisedStaysBounded) {
    for_each_order<ShWeight::normalised>([&](auto model) {
        using Model = decltype(model);
        // On a flat texel, the bound is the peak of the kernel over its value at the surface.
        for (const double incidence : {0.0, 45.0, 76.0, 89.0}) {
            const Vec3 light = direction(incidence * degrees);
            const double peak = kernel(Model::order, 1) / kernel(Model::order, light.z);
            EXPECT_LE(largest_answer<Model::order>(held_after<Model>(light, light.z)), peak * (1 + 1e-4))
                << "order " << Model::order << ", incidence " << incidence;
        }
        // On a curved texel, light may come from around the kernel's zeros, 104 and 145 degrees. The bound is
        // what a hit at 60 degrees from the texel's normal may bring to a triangle of its own.
        if (Model::order == 0) return;
        for (double incidence = 90.5; incidence < 150; incidence += 0.5) {
            const Vec3 light = direction(incidence * degrees);
            const double bound =
                2 * double{shlm::largest_surface_share<Model::order>} * kernel(Model::order, 1);
            EXPECT_LE(largest_answer<Model::order>(held_after<Model>(light, 0.5)),
                      std::max(bound, 1.0) * (1 + 1e-4))
                << "order " << Model::order << ", incidence " << incidence;
        }
    });
}

TEST(TexelModel, LightFromAboveNeverNeedsMoreThanTheLargestShare) {
    const auto largest = [](int order) {
        double share = 0;
        for (double x = 1e-3; x <= 1; x += 1e-5) share = std::max(share, x / kernel(order, x));
        return share;
    };
    EXPECT_NEAR(largest(1), double{shlm::largest_surface_share<1>}, 1e-5);
    EXPECT_NEAR(largest(2), double{shlm::largest_surface_share<2>}, 1e-5);
    EXPECT_NEAR(largest(4), double{shlm::largest_surface_share<4>}, 1e-5);
}

/// Makes light of perpendicular irradiance 1 from `towards_light`.
HitBatch unit_light(const Vec3& towards_light) {
    return one_hit(towards_light, Rgb(1, 2, 3) * towards_light.z);
}

TEST(TexelModel, OneLightGivesTheTruncatedKernel) {
    for (const double incidence : {0.0, 30.0, 60.0, 85.0})
        for_each_order<ShWeight::radiance>([&](auto model) {
            const Vec3 light = direction(incidence * degrees, 0.7);
            const Floor<decltype(model)> floor(unit_light(light));
            for (const Vec3& normal : normals()) {
                const auto expected = static_cast<float>(kernel(model.order, light.dot(normal)));
                expect_near(floor.irradiance(normal), Rgb(1, 2, 3) * expected, 1e-5,
                            name_of(model.order, normal));
            }
        });
    EXPECT_EQ(kernel(1, 1), 0.75);
    EXPECT_EQ(kernel(2, 1), 34.0 / 32);
    EXPECT_EQ(kernel(4, 1), 31.0 / 32);
}

TEST(TexelModel, FluxWeightLacksTheCosine) {
    for (const double incidence : {0.0, 30.0, 60.0, 85.0, 89.99})
        for_each_order<ShWeight::flux>([&](auto model) {
            const Vec3 light = direction(incidence * degrees, 0.7);
            const Floor<decltype(model)> floor(unit_light(light));
            for (const Vec3& normal : normals()) {
                const auto expected = static_cast<float>(light.z * kernel(model.order, light.dot(normal)));
                expect_near(floor.irradiance(normal), Rgb(1, 2, 3) * expected, 1e-5,
                            name_of(model.order, normal));
            }
        });
}

/// Makes a sky of radiance 1: directions of equal solid angle, with two Gauss points per step in z, which
/// integrate polynomials of the third degree exactly.
HitBatch uniform_hemisphere() {
    constexpr int z_steps = 60, turns = 32;
    constexpr double solid_angle = 2 * pi / (2.0 * z_steps * turns);
    HitBatch hits;
    for (int i = 0; i < z_steps; ++i)
        for (const double side : {-1.0, 1.0})
            for (int j = 0; j < turns; ++j) {
                const double z = (i + 0.5 + 0.5 * side / std::sqrt(3.0)) / z_steps;
                const Vec3 light = direction(std::acos(z), 2 * pi * (j + 0.5) / turns);
                add_hit(hits, light, Rgb(1, 2, 3) * static_cast<float>(z * solid_angle));
            }
    return hits;
}

TEST(TexelModel, UniformHemisphereIsRightAtEveryTilt) {
    // The hemisphere has no even band except the 0th, and the clamped cosine no odd one except the 1st, so
    // nothing is truncated.
    const HitBatch hits = uniform_hemisphere();
    for_each_model([&](auto model) {
        using Model = decltype(model);
        if constexpr (Model::order > 0 && Model::weight != ShWeight::flux) {
            const Floor<Model> floor(hits);
            for (const Vec3& normal : normals()) {
                const auto expected = static_cast<float>(pi * (1 + normal.z) / 2);
                expect_near(floor.irradiance(normal), Rgb(1, 2, 3) * expected, 2e-5,
                            name_of(model.order, normal));
            }
        }
    });
    // Order 0 sees the mean over the whole sphere, half of which is dark.
    const Floor<TexelModel<0, ShWeight::radiance>> flat(hits);
    for (const Vec3& normal : normals())
        expect_near(flat.irradiance(normal), Rgb(1, 2, 3) * static_cast<float>(pi / 2), 2e-5,
                    name_of(0, normal));
}

TEST(TexelModel, NoLightIsZero) {
    for_each_model([](auto model) {
        using Model = decltype(model);
        const Floor<Model> dark(HitBatch{}), zero(one_hit(direction(0.5), Rgb(0, 0, 0))),
            red(one_hit(direction(0.5), Rgb(1, 0, 0)));
        for (const Vec3& normal : normals()) {
            EXPECT_EQ(dark.irradiance(normal), Rgb(0, 0, 0)) << name_of(model.order, normal);
            EXPECT_EQ(zero.irradiance(normal), Rgb(0, 0, 0)) << name_of(model.order, normal);
            EXPECT_EQ(red.irradiance(normal).y, 0) << name_of(model.order, normal);
            EXPECT_EQ(red.irradiance(normal).z, 0) << name_of(model.order, normal);
        }
        EXPECT_GT(red.irradiance(up).x, 0) << name_of(model.order, up);
        EXPECT_EQ(shlm::IrradianceMean().irradiance(), Rgb(0, 0, 0)) << "of no texels";
    });
}

}  // namespace
