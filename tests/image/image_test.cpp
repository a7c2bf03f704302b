// Tests how image files store their values.
#include "common/image/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/core/input_error.h"
#include "tests/support/gltf_text.h"

namespace {

using common::Image;
using gltf_text::TemporaryDirectory;

/// Makes values from a quarter of `scale` to one and a quarter of it, in three channels.
Image ramp(float scale) {
    Image image{64, 32, {"R", "G", "B"}, {}};
    for (std::size_t i = 0; i < 3 * image.pixel_count(); ++i)
        image.values.push_back(scale * (0.25f + static_cast<float>(i) / static_cast<float>(3 * 64 * 32)));
    return image;
}

/// Returns the relMSE of an image that is written and read again, as diff computes it.
double loss(const Image& image) {
    const TemporaryDirectory folder;
    common::write_exr(folder.path() / "a.exr", image, {});
    const Image back = common::read_image(folder.path() / "a.exr");
    double mean = 0, sum = 0;
    for (const float value : image.values) mean += value / static_cast<double>(image.values.size());
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        const double value = image.values[i], error = back.values[i] - value;
        sum += error * error / (value * value + 0.01 * mean * mean);
    }
    return sum / static_cast<double>(image.values.size());
}

TEST(Halves, HoldOrdinaryLight) {
    for (const float scale : {1e-3f, 1.0f, 100.0f, 5e4f})
        EXPECT_TRUE(common::fits_in_halves(ramp(scale))) << scale;
}

TEST(Halves, DoNotHoldStarlightAndSuns) {
    for (const float scale : {1e-5f, 1e-6f, 1e-7f, 1e-8f, 1e-20f, 1e-40f, 6e4f, 1e6f, 3e38f})
        EXPECT_FALSE(common::fits_in_halves(ramp(scale))) << scale;
}

TEST(Halves, LoseNoMoreThanIsSaidAtAnyScale) {
    constexpr double most = common::largest_half_loss * common::largest_half_loss;
    for (int exponent = -120; exponent <= 120; exponent += 3) {
        const float scale = std::ldexp(1.1f, exponent);
        EXPECT_LE(loss(ramp(scale)), most) << scale;
    }
}

TEST(Halves, MayLoseWhatIsNothingBesideTheRest) {
    Image image = ramp(1);
    image.values[5] = 1e-8f;
    EXPECT_TRUE(common::fits_in_halves(image));
    // In a channel of its own, such a small value is the whole signal.
    for (std::size_t p = 0; p < image.pixel_count(); ++p) image.at(p, 2) = 1e-8f;
    EXPECT_FALSE(common::fits_in_halves(image));
}

TEST(Halves, HoldBlackAndNothingThatIsNotFinite) {
    Image image = ramp(1);
    for (const float value :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        image.values[5] = value;
        EXPECT_FALSE(common::fits_in_halves(image));
    }
    image.values.assign(image.values.size(), 0);
    EXPECT_TRUE(common::fits_in_halves(image));
}

TEST(Png, SaysWhatItShows) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "a.png";
    common::write_png(file, ramp(1), 1);
    EXPECT_EQ(common::read_notes(file).at(common::shown_note), common::picture_of_light);
    common::write_png(file, 1, 1, std::vector<common::DisplayColor>{{1, 2, 3}});
    EXPECT_EQ(common::read_notes(file).at(common::shown_note), common::picture_of_errors);
}

}  // namespace
