// Tests the figures of a difference against sums made by hand, and against the results for errors of known
// size.
#include "common/difference/error_metrics.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "common/core/input_error.h"

namespace {

using common::difference;
using common::DifferenceFigures;
using common::InputError;
using common::Rgb;
using Pixels = std::vector<Rgb>;

constexpr double pi = std::numbers::pi;

Pixels grey(std::size_t count, float value) {
    return Pixels(count, Rgb(value, value, value));
}

/// Returns the cosines of a surface that turns away: from 1 to 0, one step per pixel.
Pixels cosine_ramp(std::size_t count) {
    Pixels pixels;
    for (std::size_t p = 0; p < count; ++p) {
        const auto value = static_cast<float>((static_cast<double>(p) + 0.5) / static_cast<double>(count));
        pixels.emplace_back(value, value, value);
    }
    return pixels;
}

Pixels scaled(Pixels pixels, float factor) {
    for (Rgb& pixel : pixels) pixel *= factor;
    return pixels;
}

Pixels random_pixels(std::size_t count, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    Pixels pixels;
    for (std::size_t p = 0; p < count; ++p) {
        const float r = uniform(engine), g = uniform(engine), b = uniform(engine);
        pixels.emplace_back(r, g, b);
    }
    return pixels;
}

TEST(Difference, IsWhatTheSumsGiveByHand) {
    const Pixels image = {{1.5f, 2, 2}, {1, 0, 4}}, reference = {{1, 2, 3}, {0, 0, 4}};
    const DifferenceFigures figures = difference(image, reference);
    // The reference's mean is 10 / 6, so epsilon is 1 / 36.
    EXPECT_FLOAT_EQ(figures.epsilon, 1 / 36.0f);
    EXPECT_NEAR(figures.mean_image, 10.5 / 6, 1e-12);
    EXPECT_NEAR(figures.mean_reference, 10.0 / 6, 1e-12);
    EXPECT_NEAR(figures.bias, 0.5 / 6, 1e-12);
    EXPECT_NEAR(figures.relative_bias, 0.05, 1e-12);
    EXPECT_NEAR(figures.rmse, std::sqrt(2.25 / 6), 1e-12);
    const double relmse = (0.25 / (1 + 1 / 36.0) + 1 / (9 + 1 / 36.0) + 36) / 6;
    EXPECT_NEAR(figures.relmse, relmse, 1e-6);
    EXPECT_NEAR(figures.relative_rms, std::sqrt(relmse), 1e-6);
    EXPECT_NEAR(figures.smape, (1 / (2.5 + 1 / 6.0) + 2 / (5 + 1 / 6.0) + 2 / (1 + 1 / 6.0)) / 6, 1e-6);
    EXPECT_NEAR(figures.relative_error_max, 6, 1e-6);
    EXPECT_EQ(figures.worst.pixel, 1u);
    EXPECT_EQ(figures.worst.channel, 0);
    EXPECT_EQ(figures.worst.image, 1);
    EXPECT_EQ(figures.worst.reference, 0);
}

TEST(Difference, IsNothingForTheSameImage) {
    const Pixels pixels = random_pixels(100, 1);
    const DifferenceFigures figures = difference(pixels, pixels);
    for (const double figure :
         {figures.relmse, figures.relative_rms, figures.rmse, figures.smape, figures.bias,
          figures.relative_bias, figures.relative_error_p99, figures.relative_error_max})
        EXPECT_EQ(figure, 0);
}

TEST(Difference, CountsAHundredthOfTheValuesBeyondThe99thPercentile) {
    // Relative errors of 1 / 300, 2 / 300 ... 1, times 1 / sqrt(1.01), in a mixed order.
    const Pixels reference = grey(100, 1);
    Pixels image = reference;
    for (std::size_t i = 0; i < 300; ++i) {
        const std::size_t place = i * 77 % 300;
        image[place / 3][static_cast<int>(place % 3)] += static_cast<float>(i + 1) / 300;
    }
    const DifferenceFigures figures = difference(image, reference);
    EXPECT_NEAR(figures.relative_error_p99, 297 / 300.0 / std::sqrt(1.01), 1e-6);
    EXPECT_NEAR(figures.relative_error_max, 1 / std::sqrt(1.01), 1e-6);
    EXPECT_EQ(figures.worst.pixel, 299 * 77 % 300 / 3);
    EXPECT_EQ(figures.worst.channel, 299 * 77 % 300 % 3);
}

TEST(Difference, SaysWhatAThousandthOfThePixelsHas) {
    const Pixels reference = grey(1500, 1);  // a thousandth is two pixels, rounded up
    Pixels image = reference;
    for (Rgb& pixel : image) pixel.x += 0.01f;
    image[700] += Rgb(3, 0, 0);
    image[900] += Rgb(0, 0, 4);
    const double two = 3.01 * 3.01 + 4 * 4 + 0.01 * 0.01, others = 1498 * 0.01 * 0.01;
    EXPECT_NEAR(difference(image, reference).worst_share, two / (two + others), 1e-6);
    EXPECT_EQ(difference(reference, reference).worst_share, 0);
}

TEST(Difference, OfOnePixelHasItsErrorForAllPercentiles) {
    const DifferenceFigures figures = difference(grey(1, 3), grey(1, 1));
    EXPECT_NEAR(figures.relative_error_p99, 2 / std::sqrt(1.01), 1e-6);
    EXPECT_EQ(figures.relative_error_p99, figures.relative_error_max);
}

TEST(Difference, ShowsAFactor) {
    for (const double factor : {2.0, pi, 1 / pi, 0.5, 1.01}) {
        const double error = factor - 1;
        const Pixels flat = grey(50, 0.3f), ramp = cosine_ramp(100'000);
        const DifferenceFigures on_flat = difference(scaled(flat, static_cast<float>(factor)), flat);
        EXPECT_NEAR(on_flat.relmse, error * error / 1.01, 1e-5 * error * error);
        EXPECT_NEAR(on_flat.relative_bias, error, 1e-5);
        // Over a ramp the mean of x^2 / (x^2 + e) is 1 - sqrt(e) atan(1 / sqrt(e)), and sqrt(e) is 0.1 / 2.
        const DifferenceFigures on_ramp = difference(scaled(ramp, static_cast<float>(factor)), ramp);
        EXPECT_NEAR(on_ramp.relmse / (error * error), 1 - 0.05 * std::atan(20), 1e-4);
    }
}

TEST(Difference, ShowsAMissingCosine) {
    const std::size_t count = 100'000;
    const DifferenceFigures figures = difference(grey(count, 1), cosine_ramp(count));
    // The mean of (1 - x)^2 / (x^2 + e) = 1 + (1 - e) / (x^2 + e) - 2 x / (x^2 + e) from 0 to 1.
    const double e = 0.0025;
    const double expected = 1 + (1 - e) / std::sqrt(e) * std::atan(1 / std::sqrt(e)) - std::log((1 + e) / e);
    EXPECT_NEAR(figures.relmse, expected, 1e-3);
    EXPECT_NEAR(figures.relative_bias, 1, 1e-6);
    EXPECT_NEAR(figures.worst.reference, 0, 1e-4);
}

TEST(Difference, HasTheSignOfItsBias) {
    EXPECT_NEAR(difference(grey(9, 0.75f), grey(9, 1)).bias, -0.25, 1e-12);
    EXPECT_NEAR(difference(grey(9, 0.75f), grey(9, 1)).relative_bias, -0.25, 1e-12);
    EXPECT_NEAR(difference(grey(9, -1), grey(9, 1)).relative_bias, -2, 1e-12);
}

TEST(Difference, IsRelativeToTheReferenceAlone) {
    const DifferenceFigures twice = difference(grey(9, 2), grey(9, 1));
    const DifferenceFigures half = difference(grey(9, 1), grey(9, 2));
    EXPECT_NEAR(twice.relmse / half.relmse, 4, 1e-6);
    EXPECT_EQ(twice.smape > half.smape, true) << "epsilon is the reference's";
}

TEST(Difference, DoesNotDependOnTheOrderOfPixels) {
    Pixels image = random_pixels(1000, 2), reference = random_pixels(1000, 3);
    const DifferenceFigures before = difference(image, reference);
    for (Pixels* pixels : {&image, &reference}) std::shuffle(pixels->begin(), pixels->end(), std::mt19937(4));
    const DifferenceFigures after = difference(image, reference);
    EXPECT_NEAR(after.relmse, before.relmse, 1e-12 * before.relmse);
    EXPECT_NEAR(after.rmse, before.rmse, 1e-12);
    EXPECT_NEAR(after.smape, before.smape, 1e-12);
    EXPECT_NEAR(after.bias, before.bias, 1e-12);
    EXPECT_EQ(after.relative_error_p99, before.relative_error_p99);
    EXPECT_EQ(after.relative_error_max, before.relative_error_max);
    EXPECT_EQ(after.worst.image, before.worst.image);
    EXPECT_EQ(image[after.worst.pixel][after.worst.channel], after.worst.image);
}

TEST(Difference, DoesNotDependOnTheUnit) {
    const Pixels image = random_pixels(1000, 5), reference = random_pixels(1000, 6);
    const DifferenceFigures before = difference(image, reference);
    for (const float factor : {0x1p-20f, 8.0f, 0x1p20f}) {  // powers of two round nothing
        const DifferenceFigures after = difference(scaled(image, factor), scaled(reference, factor));
        EXPECT_DOUBLE_EQ(after.relmse, before.relmse);
        EXPECT_DOUBLE_EQ(after.smape, before.smape);
        EXPECT_DOUBLE_EQ(after.relative_bias, before.relative_bias);
        EXPECT_DOUBLE_EQ(after.relative_error_p99, before.relative_error_p99);
        EXPECT_DOUBLE_EQ(after.relative_error_max, before.relative_error_max);
        EXPECT_DOUBLE_EQ(after.rmse, factor * before.rmse);
        EXPECT_DOUBLE_EQ(after.bias, factor * before.bias);
        EXPECT_FLOAT_EQ(after.epsilon, factor * factor * before.epsilon);
    }
}

TEST(Difference, RefusesWhatIsNotComparable) {
    EXPECT_THROW((void)difference(grey(3, 1), grey(4, 1)), InputError);
    EXPECT_THROW((void)difference({}, {}), InputError);
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()}) {
        EXPECT_THROW((void)difference(grey(4, value), grey(4, 1)), InputError);
        EXPECT_THROW((void)difference(grey(4, 1), grey(4, value)), InputError);
        for (int c = 0; c < 3; ++c) {
            Pixels one = grey(4, 1);
            one[2][c] = value;
            EXPECT_THROW((void)difference(one, grey(4, 1)), InputError);
            EXPECT_THROW((void)difference(grey(4, 1), one), InputError);
        }
    }
}

TEST(RelativeEpsilon, RefusesAReferenceThatIsNoMeasure) {
    EXPECT_FLOAT_EQ(common::relative_epsilon(grey(5, 2)), 0.04f);
    EXPECT_FLOAT_EQ(common::relative_epsilon(Pixels{{3, 0, 0}}), 0.01f);
    EXPECT_THROW((void)common::relative_epsilon(grey(5, 0)), InputError);
    EXPECT_THROW((void)common::relative_epsilon(Pixels{{1, -1, 0}}), InputError);
    EXPECT_THROW((void)common::relative_epsilon({}), InputError);
    // The square would underflow or overflow as a float, and every error would be infinite or zero.
    EXPECT_THROW((void)common::relative_epsilon(grey(5, 1e-30f)), InputError);
    EXPECT_THROW((void)common::relative_epsilon(grey(5, 1e30f)), InputError);
}

}  // namespace
