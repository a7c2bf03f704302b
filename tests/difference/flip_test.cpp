// Tests FLIP against the published evaluator, and against consequences of its definition.
#include "common/difference/flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>

#include "common/core/input_error.h"
#include "common/core/threads.h"

namespace {

using common::Rgb;
using Pixels = std::vector<Rgb>;

constexpr int width = 48, height = 32;

std::size_t place(int x, int y) {
    return static_cast<std::size_t>(y) * width + x;
}

/// Makes a picture with value(x, y, channel) in every pixel and channel.
template <class Function>
Pixels picture(Function value) {
    Pixels pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.emplace_back(static_cast<float>(value(x, y, 0)), static_cast<float>(value(x, y, 1)),
                                static_cast<float>(value(x, y, 2)));
    return pixels;
}

Pixels uniform(const Rgb& color) {
    return Pixels(std::size_t{width} * height, color);
}

/// Hashes its arguments to a number in [0, 1).
double noise(int x, int y, int c) {
    const auto hash = (static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^
                       static_cast<std::uint32_t>(c) * 83492791u) *
                      2654435761u;
    return (hash >> 8) * 0x1p-24;
}

/// Soft coloured spots, 0.1 to 0.9.
double spots(int x, int y, int c) {
    return 0.5 + 0.4 * std::sin(0.3 * x + c) * std::cos(0.2 * y - 0.5 * c);
}

/// Returns the same under light that increases a thousandfold from left to right.
double bright_spots(int x, int y, int c) {
    return spots(x, y, c) * std::pow(10.0, x / 16.0 - 1);
}

double tint(int c) {
    return std::array{0.7, 1.0, 1.1}[c];
}

// The results of flip_evaluator 1.7 from the Python Package Index for these pictures, by evaluate(reference,
// image, "LDR" or "HDR", inputsRGB=False, applyMagma=False).

struct Recorded {
    const char* name;
    Pixels image, reference;
    double mean;
    std::array<double, 4> values;  ///< at (0, 0), (25, 16), (20, 10) and (47, 31)
};

void expect_recorded(const Recorded& recorded, const std::vector<float>& map) {
    SCOPED_TRACE(recorded.name);
    constexpr double tolerance = 1e-4;
    EXPECT_NEAR(common::flip_mean(map), recorded.mean, tolerance);
    EXPECT_NEAR(map[place(0, 0)], recorded.values[0], tolerance);
    EXPECT_NEAR(map[place(25, 16)], recorded.values[1], tolerance);
    EXPECT_NEAR(map[place(20, 10)], recorded.values[2], tolerance);
    EXPECT_NEAR(map[place(47, 31)], recorded.values[3], tolerance);
}

TEST(Flip, OfDisplayedImagesIsThePublishedEvaluators) {
    const std::array<Recorded, 4> all = {{
        {"noise",
         picture([](int x, int y, int c) { return spots(x, y, c) + 0.2 * (noise(x, y, c) - 0.5); }),
         picture(spots),
         0.1071426,
         {0.168802, 0.207715, 0.093228, 0.220817}},
        {"shifted edge",
         picture([](int x, int, int) { return x < 26 ? 0.8 : 0.1; }),
         picture([](int x, int, int) { return x < 24 ? 0.8 : 0.1; }),
         0.0786745,
         {0, 0.796869, 0.021610, 0}},
        {"tint",
         picture([](int x, int y, int c) { return 0.9 * spots(x, y, c) * tint(c); }),
         picture([](int x, int y, int c) { return 0.9 * spots(x, y, c); }),
         0.3014065,
         {0.312067, 0.196215, 0.289593, 0.392125}},
        {"black for white",
         uniform({0, 0, 0}),
         uniform({1, 1, 1}),
         0.9673883,
         {0.967388, 0.967388, 0.967388, 0.967388}},
    }};
    for (const Recorded& recorded : all)
        expect_recorded(recorded,
                        common::displayed_flip_map(recorded.image, recorded.reference, width, height));
}

TEST(Flip, IsThePublishedEvaluators) {
    const std::array<Recorded, 6> all = {{
        {"noise",
         picture([](int x, int y, int c) { return bright_spots(x, y, c) * (0.75 + 0.5 * noise(x, y, c)); }),
         picture(bright_spots),
         0.0927525,
         {0.104386, 0.160435, 0.096435, 0.144133}},
        {"shifted edge",
         picture([](int x, int, int) { return x < 26 ? 20 : 0.1; }),
         picture([](int x, int, int) { return x < 24 ? 20 : 0.1; }),
         0.1044518,
         {0, 0.950084, 0.029491, 0}},
        {"tint",
         picture([](int x, int y, int c) { return bright_spots(x, y, c) * tint(c); }),
         picture(bright_spots),
         0.2437085,
         {0.149710, 0.246974, 0.253764, 0.167941}},
        {"firefly",
         picture([](int x, int y, int c) { return bright_spots(x, y, c) + (x == 20 && y == 10 ? 1000 : 0); }),
         picture(bright_spots),
         0.0081925,
         {0, 0.001259, 0.773321, 0}},
        {"noise on black",
         picture([](int x, int y, int c) { return x < 30 ? 0.001 * noise(x, y, c) : bright_spots(x, y, c); }),
         picture([](int x, int y, int c) { return x < 30 ? 0 : bright_spots(x, y, c); }),
         0.6527389,
         {0.982019, 0.983481, 0.972568, 0}},
        {"darker",
         picture([](int x, int y, int c) { return 0.8 * bright_spots(x, y, c); }),
         picture(bright_spots),
         0.2638474,
         {0.247338, 0.280537, 0.274074, 0.154350}},
    }};
    for (const Recorded& recorded : all)
        expect_recorded(recorded, common::flip_map(recorded.image, recorded.reference, width, height));
}

// Consequences of the definition.

float largest(const std::vector<float>& map) {
    return *std::max_element(map.begin(), map.end());
}

float largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    float most = 0;
    for (std::size_t p = 0; p < a.size(); ++p) most = std::max(most, std::abs(a[p] - b[p]));
    return most;
}

/// Rounding of the sums of some twenty floats, and the steep root of FLIP near zero difference.
constexpr float rounding = 1e-4f;

Pixels mirrored(const Pixels& pixels) {
    return picture([&](int x, int y, int c) { return pixels[place(width - 1 - x, y)][c]; });
}

TEST(Flip, IsNothingForTheSameImage) {
    const Pixels pixels = picture(bright_spots);
    EXPECT_EQ(largest(common::flip_map(pixels, pixels, width, height)), 0);
    const Pixels shown = picture(spots);
    EXPECT_EQ(largest(common::displayed_flip_map(shown, shown, width, height)), 0);
}

TEST(Flip, StaysBetweenNothingAndOne) {
    const Pixels dark = uniform({0, 0, 0}), reference = picture(bright_spots);
    const Pixels blinding = uniform({3e38f, 3e38f, 3e38f});
    const Pixels negative = uniform({-1, -5, -3e38f});
    for (const Pixels& image : {dark, blinding, negative}) {
        const auto map = common::flip_map(image, reference, width, height);
        for (const float value : map) {
            ASSERT_GE(value, 0);
            ASSERT_LE(value, 1);
        }
        EXPECT_GT(common::flip_mean(map), 0.5);
    }
    EXPECT_EQ(common::flip_map(negative, reference, width, height),
              common::flip_map(dark, reference, width, height));
}

TEST(Flip, OfDisplayedImagesMayBeExchanged) {
    const Pixels a = picture(spots), b = picture([](int x, int y, int c) { return spots(y, x, 2 - c); });
    EXPECT_EQ(common::displayed_flip_map(a, b, width, height),
              common::displayed_flip_map(b, a, width, height));
}

TEST(Flip, IsMirroredWithItsImages) {
    const Pixels reference = picture(bright_spots);
    const Pixels image =
        picture([](int x, int y, int c) { return bright_spots(x, y, c) * (0.5 + noise(x, y, c)); });
    const auto map = common::flip_map(image, reference, width, height);
    auto mirrored_map = common::flip_map(mirrored(image), mirrored(reference), width, height);
    for (int y = 0; y < height; ++y)
        std::reverse(mirrored_map.begin() + y * width, mirrored_map.begin() + (y + 1) * width);
    EXPECT_LT(largest_difference(map, mirrored_map), rounding);
}

TEST(Flip, DoesNotDependOnTheUnit) {
    const auto map_in = [](double unit) {
        return common::flip_map(picture([=](int x, int y, int c) {
                                    return unit * bright_spots(x, y, c) * (0.5 + noise(x, y, c));
                                }),
                                picture([=](int x, int y, int c) { return unit * bright_spots(x, y, c); }),
                                width, height);
    };
    EXPECT_LT(largest_difference(map_in(1), map_in(1000)), rounding);
    EXPECT_LT(largest_difference(map_in(1), map_in(0.001)), rounding);
}

TEST(Flip, SeesAFireflyWhereItIs) {
    const Pixels reference = picture(bright_spots);
    Pixels image = reference;
    image[place(30, 12)] = {100, 100, 100};
    const auto map = common::flip_map(image, reference, width, height);
    EXPECT_EQ(std::max_element(map.begin(), map.end()) - map.begin(), place(30, 12));
    EXPECT_GT(map[place(30, 12)], 0.25f);
    EXPECT_LT(map[place(2, 12)], rounding);
}

TEST(Flip, IsTheSameForAnyNumberOfThreads) {
    const Pixels reference = picture(bright_spots);
    const Pixels image =
        picture([](int x, int y, int c) { return bright_spots(x, y, c) * (0.5 + noise(x, y, c)); });
    const auto with_threads = [&](int threads) {
        common::ThreadPool pool(threads);
        return pool.run([&] { return common::flip_map(image, reference, width, height); });
    };
    EXPECT_EQ(with_threads(1), with_threads(3));
}

TEST(Flip, RefusesWhatItCannotCompare) {
    const Pixels good = uniform({1, 1, 1});
    const Pixels shorter(good.begin(), good.end() - 1);
    EXPECT_THROW((void)common::flip_map(shorter, good, width, height), common::InputError);
    EXPECT_THROW((void)common::flip_map(good, shorter, width, height), common::InputError);
    EXPECT_THROW((void)common::flip_map(good, good, width, height - 1), common::InputError);
    EXPECT_THROW((void)common::flip_map({}, {}, 0, 0), common::InputError);
    EXPECT_THROW((void)common::flip_map(good, uniform({0, 0, 0}), width, height), common::InputError);
    EXPECT_THROW((void)common::displayed_flip_map(shorter, good, width, height), common::InputError);
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Pixels bad = good;
        bad[place(47, 31)].z = value;
        EXPECT_THROW((void)common::flip_map(bad, good, width, height), common::InputError);
        EXPECT_THROW((void)common::flip_map(good, bad, width, height), common::InputError);
        EXPECT_THROW((void)common::displayed_flip_map(bad, good, width, height), common::InputError);
    }
}

}  // namespace
