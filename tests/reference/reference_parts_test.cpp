// Tests the parts of the reference separately.
#include "common/reference/direction_choice.h"
#include "common/reference/directions.h"
#include "common/reference/expected_light.h"
#include "common/reference/light_sample.h"
#include "common/reference/paths_not_found.h"
#include "common/reference/straight_line.h"
#include "common/reference/strata.h"
#include "tests/support/reference_tracing.h"
#include "tests/support/see_through.h"

namespace {

using namespace tests;
using namespace common::reference;

constexpr std::uint64_t draws = count_for(1'000'000, 100'000);

// --- random numbers

TEST(ReferenceRandom, IsThreefry) {
    // Threefry4x32-20 of counter 0 and key 0: the known answer that is part of Random123.
    const std::array<std::uint32_t, 4> bits = {0x9c6ca96a, 0xe17eae66, 0xfc10ecd4, 0x5256a7d8};
    RandomStream stream(0, 0, 0, 0);
    for (const std::uint32_t b : bits) EXPECT_EQ(stream.next(), (b + 0.5) / 4294967296.0);
}

/// Returns the probability of counts at least as uneven as these, if all cells are equally likely.
double chance_of(const std::vector<std::uint64_t>& counts, std::uint64_t total) {
    const std::vector<double> expected(counts.size(),
                                       static_cast<double>(total) / static_cast<double>(counts.size()));
    return chi_square_tail(chi_square(counts, expected), static_cast<int>(counts.size()) - 1);
}

/// Draws pairs of numbers that must be independent, and counts them in all cells of the unit square.
template <class Draw>
void expect_independent(const char* what, Draw draw) {
    constexpr std::size_t side = 17;
    std::vector<std::uint64_t> counts(side * side);
    for (std::uint32_t i = 0; i < draws; ++i) {
        const auto [a, b] = draw(i);
        ASSERT_GT(a, 0);
        ASSERT_LT(a, 1);
        ++counts[static_cast<std::size_t>(a * side) * side + static_cast<std::size_t>(b * side)];
    }
    EXPECT_GT(chance_of(counts, draws), 1e-5) << what;
}

TEST(ReferenceRandom, StreamsAreUniformAndIndependent) {
    const auto first = [](std::uint64_t seed, std::uint32_t pixel, std::uint32_t pass, std::uint32_t sample) {
        return RandomStream(seed, pixel, pass, sample).next();
    };
    expect_independent("pixels",
                       [&](std::uint32_t i) { return std::pair(first(1, i, 0, 0), first(1, i + 1, 0, 0)); });
    expect_independent("passes",
                       [&](std::uint32_t i) { return std::pair(first(1, 0, i, 0), first(1, 0, i + 1, 0)); });
    expect_independent("samples",
                       [&](std::uint32_t i) { return std::pair(first(1, i, 0, 0), first(1, i, 0, 1)); });
    expect_independent("seeds",
                       [&](std::uint32_t i) { return std::pair(first(i, 0, 0, 0), first(i + 1, 0, 0, 0)); });
    constexpr auto high = std::uint64_t{1} << 32;
    expect_independent("seeds 2^32 apart", [&](std::uint32_t i) {
        return std::pair(first(1, i, 0, 0), first(1 + high, i, 0, 0));
    });
    expect_independent("neighbours of one stream", [&](std::uint32_t i) {
        RandomStream stream(1, i, 0, 0);
        for (std::uint32_t skip = 0; skip < i % 7; ++skip) stream.next();
        const double a = stream.next();
        return std::pair(a, stream.next());
    });
}

// --- strata

TEST(ReferenceStrata, EachCellIsTakenOnceInEveryPass) {
    for (std::uint32_t pass = 0; pass < 50; ++pass) {
        const PassStrata strata(1, 2, pass);
        std::array<int, samples_per_pass> direction{}, on_light{}, which{};
        const auto cell = [](const std::array<double, 2>& p) {
            return static_cast<std::size_t>(p[1] * 8) * 8 + static_cast<std::size_t>(p[0] * 8);
        };
        for (std::uint32_t i = 0; i < samples_per_pass; ++i) {
            RandomStream stream(1, 2, pass, i);
            const FirstNumbers numbers = strata.numbers(i, stream);
            ++direction[cell(numbers.direction)];
            ++on_light[cell(numbers.on_light)];
            ++which[static_cast<std::size_t>(numbers.which_light * samples_per_pass)];
        }
        for (std::size_t i = 0; i < samples_per_pass; ++i) {
            EXPECT_EQ(direction[i], 1);
            EXPECT_EQ(on_light[i], 1);
            EXPECT_EQ(which[i], 1);
        }
    }
}

/// Over many passes, the direction is independent of the position on the light, and the position inside a
/// cell is uniform.
TEST(ReferenceStrata, ArePairedAtRandom) {
    std::vector<std::uint64_t> pairs(8 * 8 * 8 + 1), inside(289);
    std::uint64_t total = 0;
    for (std::uint32_t pass = 0; pass < draws / samples_per_pass; ++pass) {
        const PassStrata strata(1, 0, pass);
        const std::uint32_t i =
            pass % samples_per_pass;  // one per pass, as samples of a pass are not independent
        RandomStream stream(1, 0, pass, i);
        const FirstNumbers n = strata.numbers(i, stream);
        const auto eighth = [](double x) { return static_cast<std::size_t>(x * 8); };
        ++pairs[eighth(n.direction[0]) * 64 + eighth(n.on_light[0]) * 8 + eighth(n.which_light)];
        const auto seventeenth = [](double x) {
            return static_cast<std::size_t>((x * 8 - std::floor(x * 8)) * 17);
        };
        ++inside[seventeenth(n.direction[0]) * 17 + seventeenth(n.on_light[1])];
        ++total;
    }
    pairs.pop_back();
    const std::vector<double> expected(pairs.size(),
                                       static_cast<double>(total) / static_cast<double>(pairs.size()));
    // With 511 degrees of freedom, the cube root of chi-square is practically normal (Wilson and Hilferty).
    const double d = 511, ratio = std::cbrt(chi_square(pairs, expected) / d);
    EXPECT_LT((ratio - (1 - 2 / (9 * d))) / std::sqrt(2 / (9 * d)), z_for(1e-5));
    EXPECT_GT(chance_of(inside, total), 1e-5);
}

// --- directions

TEST(ReferenceDirections, FollowTheCosine) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(1, -2, 3).normalized()}) {
        // The squared cosine to the axis and the azimuth about it are uniform.
        const common::Frame frame(axis);
        std::vector<std::uint64_t> counts(17 * 17);
        for (std::uint64_t i = 0; i < draws; ++i) {
            const Vec3 direction = cosine_direction(axis, {uniform(engine), uniform(engine)});
            ASSERT_NEAR(direction.length(), 1, 1e-6);
            const double cosine = static_cast<double>(direction.dot(axis));
            ASSERT_GE(cosine, 0);
            const double turn = std::atan2(static_cast<double>(direction.dot(frame.bitangent)),
                                           static_cast<double>(direction.dot(frame.tangent))) /
                                    (2 * pi) +
                                0.5;
            const auto bin = [](double x) {
                return std::min<std::size_t>(16, static_cast<std::size_t>(x * 17));
            };
            ++counts[bin(cosine * cosine) * 17 + bin(turn)];
        }
        EXPECT_GT(chance_of(counts, draws), 1e-5);
    }
}

TEST(ReferenceDirections, DiscKeepsTheMiddleAndReachesTheRim) {
    EXPECT_EQ(concentric_disc({0.5, 0.5}), (std::array<double, 2>{0, 0}));
    for (const auto& corner : {std::array<double, 2>{1, 1}, {0, 1}, {1, 0}, {0, 0.3}, {0.7, 1}}) {
        const auto [x, y] = concentric_disc(corner);
        EXPECT_NEAR(std::hypot(x, y), 1, 1e-12);
    }
}

// --- running mean

TEST(ReferenceDirections, AimedOnesKnowTheirDensity) {
    const Vec3 axis = Vec3(1, 2, 4).normalized();
    const Receiver receiver{Vec3(0.1f, -0.3f, 0.2f), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    for (const double radius : {0.5, 0.1, 1e-2, 1e-3, 1e-4}) {  // at a distance of 1
        const std::vector<SpecularBounds> bounds = {{Imath::V3d(receiver.origin) + Imath::V3d(axis), radius}};
        const DirectionChoice choice(bounds, receiver);
        const double least_inside = choice.density(axis) * 0.9;  // the cosine's part varies across the cone
        RandomStream stream(1, 0, 0, 0);
        std::uint64_t outside = 0;
        Sample cosine_over_density;
        constexpr std::uint64_t aimed = draws / 2;
        for (std::uint64_t i = 0; i < draws; ++i) {
            // The first half of the square is used for aimed directions.
            const double first = i < aimed ? 0.5 * stream.next() : 0.5 + 0.5 * stream.next();
            const Vec3 towards = choice.choose({first, stream.next()});
            const double density = choice.density(towards);
            outside += i < aimed && density < least_inside;
            cosine_over_density.add(std::max(0.0f, towards.z) / pi / density);
        }
        // Rounding in floats moves the outermost ones out of the smallest cones.
        EXPECT_LE(static_cast<double>(outside), 1e-2 * static_cast<double>(aimed)) << "radius " << radius;
        EXPECT_NEAR(cosine_over_density.mean(), 1, 5 * cosine_over_density.standard_error())
            << "radius " << radius;
    }
}

TEST(ReferenceMean, IsThatOfTheValues) {
    std::mt19937 engine(1);
    std::lognormal_distribution<double> values(3, 2);
    RunningMean running;
    Sample sample;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        const double value = values(engine);
        running.add(value, i);
        sample.add(value);
        if (i == 0) {
            EXPECT_EQ(running.variance().value(), 0);
            continue;
        }
        ASSERT_NEAR(running.mean().value(), sample.mean(), 1e-11 * sample.mean());
        ASSERT_NEAR(std::sqrt(running.variance().value()), sample.standard_error(),
                    1e-11 * sample.standard_error());
    }
}

TEST(ReferenceMean, GoesOnFromItsFloatsAsIfItHadNotStopped) {
    std::mt19937 engine(2);
    std::lognormal_distribution<double> values(-20, 8);  // far below and above 1
    RunningMean whole, stopped;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const double value = values(engine);
        whole.add(value, i);
        stopped.add(value, i);
        // These four floats are what a file keeps.
        const volatile float kept[4] = {stopped.mean().high, stopped.mean().low, stopped.variance().high,
                                        stopped.variance().low};
        stopped = {{kept[0], kept[1]}, {kept[2], kept[3]}};
        ASSERT_EQ(whole.mean().value(), stopped.mean().value());
        ASSERT_EQ(whole.variance().value(), stopped.variance().value());
    }
}

TEST(ReferenceMean, PairHoldsWhatOneFloatCannot) {
    const double value = 1 + 0x1p-40;
    EXPECT_NE(static_cast<double>(static_cast<float>(value)), value);
    EXPECT_EQ(rounded_pair(value).value(), value);
}

// --- lights

/// Makes a floor with a point, and all kinds of light around it at random.
Scene random_lights(std::mt19937& engine, std::size_t count) {
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto anywhere = [&] { return Vec3(uniform(engine), uniform(engine), uniform(engine)) * 2.0f; };
    Scene scene;
    add(scene, quad({-0.01f, 0, -0.01f}, {0, 0, 0.02f}, {0.02f, 0, 0}), diffuse(Rgb(0, 0, 0)));
    for (std::size_t i = 0; i < count; ++i) {
        Mesh mesh = quad(anywhere(), anywhere() * 0.5f, anywhere() * 0.5f);
        const Material material = diffuse(Rgb(0, 0, 0), Rgb(1, 0, 0));
        add(scene, mesh, i % 2 == 0 ? material : double_sided(material));
        scene.point_light.push_back({anywhere(), Rgb(1, 0, 0)});
        scene.spot_light.push_back({anywhere(), anywhere().normalized(), Rgb(1, 0, 0), 0.9f, 0.2f});
        scene.directional_light.push_back({anywhere().normalized(), Rgb(1, 0, 0)});
    }
    return scene;
}

Receiver random_receiver(const Scene& scene, std::mt19937& engine) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const SurfacePoint point =
        tilted(front_of(scene, on_quad(0, 0.5f, 0.5f)), 1.2 * uniform(engine), uniform(engine));
    return {point.position, point.shading_normal, point.geometric_normal};
}

TEST(ReferenceLights, WhatIsExpectedToBringNothingBringsNothing) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::size_t bright = 0, dark = 0;
    for (int round = 0; round < 20; ++round) {
        const Scene scene = random_lights(engine, 25);
        const common::RayScene rays(scene);
        const Lights lights(scene);
        const Receiver receiver = random_receiver(scene, engine);
        for (const Light& light : lights.light()) {
            const double expected = expected_irradiance(light, receiver);
            EXPECT_GE(expected, 0);
            (expected > 0 ? bright : dark) += 1;
            for (int i = 0; i < 20; ++i) {
                const auto sample = sample_light(rays, light, receiver, {uniform(engine), uniform(engine)});
                if (sample && sample->irradiance.x > 0) {
                    EXPECT_GT(expected, 0);
                }
            }
        }
    }
    EXPECT_GT(bright, 100u);
    EXPECT_GT(dark, 100u);
}

TEST(ReferenceLights, AreChosenWithTheProbabilityThatIsSaid) {
    std::mt19937 engine(1);
    for (const std::size_t count : {5, 30}) {  // 25 and 150 lights: weighed, and by power
        const Scene scene = random_lights(engine, count);
        const Lights lights(scene);
        ASSERT_EQ(lights.light().size(), 5 * count);
        const LightChoice choice(lights, random_receiver(scene, engine));
        double sum = 0, before = 0;
        for (std::int32_t light = 0; light < std::ssize(lights.light()); ++light) {
            const double probability = choice.probability(light);
            sum += probability;
            if (probability <= 0) continue;
            EXPECT_EQ(choice.choose(before + 0.5 * probability), light);
            before += probability;
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        EXPECT_EQ(choice.choose(1 - 0x1p-33) >= 0, true);
    }
}

TEST(ReferenceLights, NarrowSpotsFallOffByTheirAngle) {
    for (const double degrees : {1e-3, 0.02, 0.3, 3.5}) {
        const double angle = degrees * pi / 180, versine = 2 * std::pow(std::sin(angle / 2), 2);
        // The ramp covers the outer half of 1 - cosine.
        const common::SpotLight spot{{0, 0, 0}, Vec3(0, 0, -1), Rgb(1, 1, 1), 1 - versine / 2, 1 - versine};
        const auto at = [&](double share) {  // of the outer 1 - cosine
            const double off_axis = 2 * std::asin(std::sqrt(share * versine / 2));
            return falloff(spot, {std::sin(off_axis), 0, -std::cos(off_axis)});
        };
        EXPECT_EQ(at(0), 1);
        EXPECT_EQ(at(0.49), 1);
        EXPECT_NEAR(at(0.75), 0.25, 1e-5);
        EXPECT_EQ(at(1.01), 0);
        EXPECT_NEAR(power_of(Light(spot), 1), 2 * pi * versine * (0.5 + 0.5 / 3), 1e-5 * versine);
    }
    const common::SpotLight sharp{{0, 0, 0}, Vec3(0, 0, -1), Rgb(1, 1, 1), 1 - 1e-9, 1 - 1e-9};
    EXPECT_EQ(falloff(sharp, {4e-5, 0, -1}), 1);
    EXPECT_EQ(falloff(sharp, {5e-5, 0, -1}), 0);
}

TEST(ReferenceLights, PlacesAreChosenByWhatTheyEmit) {
    constexpr int across = 3;
    const std::vector<double> cell = {1, 0, 2, 0, 0, 0, 5, 0.5, 1.5};
    const BrightPlaces places(across, cell);
    std::vector<std::uint64_t> counts(cell.size());
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (std::uint64_t i = 0; i < draws; ++i) {
        const auto [u, v] = places.place({uniform(engine), uniform(engine)});
        const auto number =
            static_cast<std::size_t>(static_cast<int>(v * across) * across + static_cast<int>(u * across));
        ASSERT_LT(number, cell.size());
        ++counts[number];
        ASSERT_DOUBLE_EQ(places.density({u, v}), cell[number] / 10 * 9);
    }
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const double p = cell[i] / 10, expected = p * static_cast<double>(draws);
        EXPECT_NEAR(static_cast<double>(counts[i]), expected, z_for(1e-6) * std::sqrt(expected * (1 - p)));
    }
}

TEST(ReferenceLights, NoneIsChosenWhereNoneShines) {
    Scene scene;
    add(scene, quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}), diffuse(Rgb(0, 0, 0)));
    scene.point_light.push_back({{0, -1, 0}, Rgb(1, 1, 1)});
    const Lights lights(scene);
    const LightChoice choice(lights, {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}});
    EXPECT_EQ(choice.choose(0.5), -1);
    EXPECT_EQ(choice.probability(0), 0);
}

TEST(ReferenceLights, TellsWhatNoPathFinds) {
    Scene scene = closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    scene.point_light.push_back({{0, 0, 0}, Rgb(1, 1, 1)});
    EXPECT_EQ(paths_not_found(scene), "");
    add(scene, sphere({0, 0, 0}, 0.2f, 0), glass());
    scene.directional_light.push_back({{0, 0, 1}, Rgb(1, 1, 1)});
    EXPECT_EQ(paths_not_found(scene), "light of 1 point, 1 directional lights by way of mirrors or glass");
    scene.material.back().kind = common::SurfaceKind::thin_sheet;  // what comes straight through is found
    EXPECT_EQ(paths_not_found(scene),
              "light of 1 point, 1 directional lights by way of reflections in thin glass");
    scene.point_light.clear();
    scene.directional_light.clear();
    EXPECT_EQ(paths_not_found(scene), "");
}

// --- shadow rays

TEST(Occluded, SeesWhatLiesBetweenAndNothingElse) {
    Scene scene;
    add(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), diffuse(Rgb(0, 0, 0)));
    const common::RayScene rays(scene);
    const Vec3 origin(0.1f, 0, 0.2f), up(0, 2, 0);
    EXPECT_TRUE(rays.occluded(origin, up, 1));
    EXPECT_TRUE(rays.occluded(origin, up, std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(rays.occluded(origin, up, 0.49f));
    EXPECT_TRUE(rays.occluded(origin, up, 0.51f));
    EXPECT_FALSE(rays.occluded(origin, -up, std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(rays.occluded(Vec3(2, 0, 0), up, std::numeric_limits<float>::infinity()));
}

TEST(Nearest, GoesAsFarAsItIsAsked) {
    Scene scene;
    add(scene, quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}), diffuse(Rgb(0, 0, 0)));
    const common::RayScene rays(scene);
    const Vec3 origin(0.1f, 0, 0.2f), up(0, 2, 0);
    EXPECT_TRUE(rays.nearest(origin, up));
    EXPECT_TRUE(rays.nearest(origin, up, 0.51f));
    EXPECT_FALSE(rays.nearest(origin, up, 0.49f));
    EXPECT_FALSE(rays.nearest(origin, -up));
}

// --- straight lines past what lets light through

TEST(StraightLine, MultipliesWhatEachSurfaceLetsThrough) {
    Scene scene;
    EXPECT_FALSE(has_see_through(scene));
    const auto add_sheet = [&](float height, const Material& material) {
        add(scene, quad({-1, height, -1}, {2, 0, 0}, {0, 0, 2}), material);
    };
    add_sheet(1, blended(diffuse(Rgb(1, 1, 1)), 1));
    EXPECT_FALSE(has_see_through(scene)) << "BLEND with alpha 1";
    scene = {};
    add_sheet(1, blended(diffuse(Rgb(0.1f, 0.2f, 0.3f)), 0.25f));
    add_sheet(2, thin_sheet(1.5f, Rgb(1, 0.5f, 0.25f)));
    add_sheet(3, diffuse(Rgb(1, 1, 1)));
    EXPECT_TRUE(has_see_through(scene));
    const common::RayScene rays(scene);
    const Vec3 below(0.1f, 0, 0.2f), up(0, 2, 0);
    const double sheet = 1 - 2 * 0.04 / 1.04;
    const auto expect_part = [&](const V3d& part, const V3d& expected) {
        EXPECT_LT((part - expected).length(), 1e-6) << part << expected;
    };
    expect_part(part_that_arrives(rays, below, up, 0.49f), V3d(1, 1, 1));
    expect_part(part_that_arrives(rays, below, up, 0.75f), V3d(0.75));
    expect_part(part_that_arrives(rays, below, up, 1.25f), V3d(1, 0.5, 0.25) * (0.75 * sheet));
    expect_part(part_that_arrives(rays, below, up, 1.51f), V3d(0, 0, 0));
    expect_part(part_that_arrives(rays, below, up, std::numeric_limits<float>::infinity()), V3d(0, 0, 0));
    expect_part(part_that_arrives(rays, {0.1f, 2.5f, 0.2f}, -up, std::numeric_limits<float>::infinity()),
                V3d(1, 0.5, 0.25) * (0.75 * sheet));
    // The ray ends on a sheet, or within rounding of it.
    for (const float reach : {0.5f, 0.5f + 1e-7f, 0.5f - 1e-7f}) {
        const V3d part = part_that_arrives(rays, below, up, reach);
        EXPECT_TRUE(part == V3d(1, 1, 1) || part == V3d(0.75)) << part;
    }
}

}  // namespace
