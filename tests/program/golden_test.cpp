// Compares renders of the project's own scenes with images that people have inspected.
#include "tests/support/golden.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using OIIO::ImageBuf;

#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool slow_build = true;
#else
constexpr bool slow_build = false;
#endif

/// Returns the image rounded to half floats, as the golden images are.
ImageBuf as_buffer(const common::Image& image) {
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()), OIIO::TypeHalf);
    spec.channelnames = image.channels;
    ImageBuf buffer(spec);
    buffer.set_pixels(buffer.roi(), OIIO::TypeFloat, image.values.data());
    return buffer;
}

class GoldenImage : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(GoldenImage, IsStillTheSame) {
    const auto [scene, method] = GetParam();
    if (slow_build && std::string(scene) == "atrium") GTEST_SKIP() << "takes too long without optimisation";
    ASSERT_TRUE(std::filesystem::exists(golden::file_of(scene, method))) << "update_golden makes it";
    const ImageBuf expected(golden::file_of(scene, method).string());

    const ImageBuf image = as_buffer(golden::render(scene, method, golden::seed));
    ASSERT_EQ(golden::obstacle(image, expected), "");

    const ImageBuf other_seed = as_buffer(golden::render(scene, method, golden::seed + 1));
    EXPECT_EQ(golden::deviation(image, expected, other_seed), "");
    EXPECT_NE(golden::deviation(other_seed, expected, other_seed), "") << "the test would pass anything";
}

std::string test_name(const testing::TestParamInfo<std::tuple<const char*, const char*>>& info) {
    const auto [scene, method] = info.param;
    return std::string(scene) + (std::string(method) == "shlm" ? "Shlm" : "PhotonMap");
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenImage,
                         testing::Combine(testing::ValuesIn(golden::scenes),
                                          testing::ValuesIn(golden::methods)),
                         test_name);

// Tests of the comparison itself.

/// Makes a grey image with a gradient; `offset` stands for different noise.
common::Image made_up(float offset = 0) {
    common::Image image{40, 20, {"R", "G", "B", "A", "irradiance.R", "irradiance.G", "irradiance.B"}, {}};
    for (std::size_t p = 0; p < image.pixel_count(); ++p)
        for (std::size_t c = 0; c < image.channels.size(); ++c)
            image.values.push_back(1 + 0.01f * static_cast<float>(p % 7) + (p % 2 == 0 ? offset : -offset));
    return image;
}

std::string obstacle(const common::Image& image) {
    return golden::obstacle(as_buffer(image), as_buffer(made_up()));
}

std::string deviation(const common::Image& image) {
    return golden::deviation(as_buffer(image), as_buffer(made_up()), as_buffer(made_up(0.2f)));
}

TEST(GoldenComparison, TakesTheSameImage) {
    EXPECT_EQ(obstacle(made_up()), "");
    EXPECT_EQ(deviation(made_up()), "");
}

TEST(GoldenComparison, FindsAnotherSize) {
    common::Image image = made_up();
    std::swap(image.width, image.height);
    EXPECT_EQ(obstacle(image), "20 x 40 pixels instead of 40 x 20");
}

TEST(GoldenComparison, FindsOtherChannels) {
    common::Image image = made_up();
    image.channels[1] = "X";
    EXPECT_EQ(obstacle(image),
              "channels R,X,B,A,irradiance.R,irradiance.G,irradiance.B instead of "
              "R,G,B,A,irradiance.R,irradiance.G,irradiance.B");
    image = made_up();
    image.channels.pop_back();
    image.values.resize(image.pixel_count() * image.channels.size());
    EXPECT_TRUE(obstacle(image).starts_with("channels R,G,B,A,irradiance.R,irradiance.G instead of"))
        << obstacle(image);
}

TEST(GoldenComparison, FindsValuesThatAreNotFinite) {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        common::Image image = made_up();
        image.at(3 * 40 + 5, 2) = value;
        EXPECT_EQ(obstacle(image), "channel B of pixel (5, 3) is not finite");
    }
}

TEST(GoldenComparison, AllowsAFewPixelsButNotAFactor) {
    common::Image image = made_up();
    for (std::size_t p = 0; p < image.pixel_count() / 100; ++p) image.at(p, 1) *= 1.1f;
    EXPECT_EQ(deviation(image), "");

    image = made_up();
    for (std::size_t p = 0; p < image.pixel_count(); ++p) image.at(p, 1) *= 1.03f;
    EXPECT_EQ(deviation(image), "radiance: 100.0 % of the pixels have changed");

    image = made_up();
    for (std::size_t p = 0; p < image.pixel_count(); ++p) image.at(p, 5) *= 1.03f;
    EXPECT_EQ(deviation(image), "irradiance: 100.0 % of the pixels have changed");
}

TEST(GoldenComparison, DoesNotAllowAFewPixelsFarOff) {
    common::Image image = made_up();
    image.at(77, 0) = 50;
    EXPECT_TRUE(deviation(image).starts_with("radiance: relative rms difference")) << deviation(image);
}

}  // namespace
