#include "common/scene/texture.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/core/input_error.h"

namespace {

using common::ColorSpace;
using common::Rgb;
using common::Texture;
using common::Vec2;
using common::Wrap;

/// Makes two pixels side by side, black and white.
Texture black_white(Wrap wrap, ColorSpace color_space = ColorSpace::linear) {
    return {"black_white", 2, 1, {0, 0, 0, 255, 255, 255}, color_space, wrap, wrap};
}

float red_at(const Texture& texture, float u, float v = 0.5f) {
    return texture.sample({u, v}).x;
}

TEST(Texture, GivesThePixelAtItsCentre) {
    // Upper row red, green; lower row blue, grey. v = 0 is the top.
    const Texture texture("four", 2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 51, 51, 51}, ColorSpace::linear,
                          Wrap::repeat, Wrap::repeat);
    EXPECT_EQ(texture.sample({0.25f, 0.25f}), Rgb(1, 0, 0));
    EXPECT_EQ(texture.sample({0.75f, 0.25f}), Rgb(0, 1, 0));
    EXPECT_EQ(texture.sample({0.25f, 0.75f}), Rgb(0, 0, 1));
    EXPECT_EQ(texture.sample({0.75f, 0.75f}), Rgb(0.2f, 0.2f, 0.2f));
}

TEST(Texture, InterpolatesBetweenPixels) {
    const Texture texture = black_white(Wrap::clamp_to_edge);
    EXPECT_FLOAT_EQ(red_at(texture, 0.5f), 0.5f);
    EXPECT_FLOAT_EQ(red_at(texture, 0.375f), 0.25f);
}

TEST(Texture, DecodesSrgbBeforeItInterpolates) {
    const Texture grey("grey", 1, 1, {128, 10, 255}, ColorSpace::srgb, Wrap::repeat, Wrap::repeat);
    const Rgb value = grey.sample({0.5f, 0.5f});
    EXPECT_NEAR(value.x, 0.215861f, 1e-6f);
    EXPECT_NEAR(value.y, 10.0f / 255 / 12.92f, 1e-7f);
    EXPECT_FLOAT_EQ(value.z, 1);
    EXPECT_FLOAT_EQ(red_at(black_white(Wrap::repeat, ColorSpace::srgb), 0.5f), 0.5f);
}

TEST(Texture, Repeats) {
    const Texture texture = black_white(Wrap::repeat);
    EXPECT_FLOAT_EQ(red_at(texture, 5.25f), 0);
    EXPECT_FLOAT_EQ(red_at(texture, -0.25f), 1);
    EXPECT_FLOAT_EQ(red_at(texture, 0), 0.5f) << "between the last pixel and the first";
}

TEST(Texture, ClampsToTheEdge) {
    const Texture texture = black_white(Wrap::clamp_to_edge);
    EXPECT_FLOAT_EQ(red_at(texture, -3), 0);
    EXPECT_FLOAT_EQ(red_at(texture, 0), 0);
    EXPECT_FLOAT_EQ(red_at(texture, 3), 1);
}

TEST(Texture, MirrorsEverySecondRepetition) {
    const Texture texture = black_white(Wrap::mirrored_repeat);
    EXPECT_FLOAT_EQ(red_at(texture, 0.75f), 1);
    EXPECT_FLOAT_EQ(red_at(texture, 1.25f), 1);
    EXPECT_FLOAT_EQ(red_at(texture, 1.75f), 0);
    EXPECT_FLOAT_EQ(red_at(texture, -0.25f), 0);
    EXPECT_FLOAT_EQ(red_at(texture, 1), 1);
}

TEST(Texture, WrapsTheTwoAxesSeparately) {
    const Texture texture("four", 1, 2, {0, 0, 0, 255, 255, 255}, ColorSpace::linear, Wrap::repeat,
                          Wrap::clamp_to_edge);
    EXPECT_FLOAT_EQ(red_at(texture, 7.5f, -1), 0);
    EXPECT_FLOAT_EQ(red_at(texture, 7.5f, 2), 1);
}

TEST(Texture, TakesAnyCoordinate) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
        const Texture texture = black_white(wrap);
        for (const float u :
             {1e30f, -1e30f, -1e-30f, infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
            EXPECT_GE(red_at(texture, u), 0);
            EXPECT_LE(red_at(texture, u), 1);
        }
    }
}

TEST(Texture, TakesTheNearestPixelWhereItIsAskedTo) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
        const Texture texture("black_white", 2, 1, {0, 0, 0, 255, 255, 255}, ColorSpace::linear, wrap, wrap,
                              {0, 255}, common::Filter::nearest);
        for (const float u : {0.0f, 0.1f, 0.25f, 0.49f}) {
            EXPECT_EQ(red_at(texture, u), 0) << u;
            EXPECT_EQ(texture.sample_alpha({u, 0.5f}), 0) << u;
        }
        for (const float u : {0.51f, 0.75f, 0.9f, 0.999f}) {
            EXPECT_EQ(red_at(texture, u), 1) << u;
            EXPECT_EQ(texture.sample_alpha({u, 0.5f}), 1) << u;
        }
        EXPECT_EQ(red_at(texture, 1.1f), wrap == Wrap::repeat ? 0 : 1);
        EXPECT_EQ(red_at(texture, -0.1f), wrap == Wrap::repeat ? 1 : 0);
    }
}

TEST(Texture, TellsApartWhat16BitsDo) {
    // Two values that round to the same byte.
    const Texture texture("fine", 2, 1, {128, 128, 128, 128, 128, 128}, ColorSpace::linear,
                          Wrap::clamp_to_edge, Wrap::clamp_to_edge, {}, common::Filter::linear,
                          {32800, 32801, 32802, 32900, 32901, 32902});
    EXPECT_EQ(texture.sample({0.25f, 0.5f}), Rgb(32800, 32801, 32802) / 65535.0f);
    EXPECT_EQ(texture.sample({0.75f, 0.5f}), Rgb(32900, 32901, 32902) / 65535.0f);
    EXPECT_FLOAT_EQ(red_at(texture, 0.5f), 32850 / 65535.0f);
    EXPECT_EQ(texture.filter(texture.footprint({0.25f, 0.5f})), Rgb(128, 128, 128) / 255.0f) << "a colour";
}

TEST(Texture, RefusesSizesThatDoNotFit) {
    const auto make = [](int width, int height, std::size_t bytes) {
        return Texture("bad", width, height, std::vector<std::uint8_t>(bytes), ColorSpace::linear,
                       Wrap::repeat, Wrap::repeat);
    };
    EXPECT_NO_THROW(make(2, 3, 18));
    EXPECT_THROW(make(2, 3, 17), common::InputError);
    EXPECT_THROW(make(2, 3, 24), common::InputError);
    EXPECT_THROW(make(0, 3, 0), common::InputError);
    EXPECT_THROW(make(2, -3, 18), common::InputError);
    const auto make_16 = [](std::size_t numbers, ColorSpace color_space) {
        return Texture("bad", 1, 1, {1, 2, 3}, color_space, Wrap::repeat, Wrap::repeat, {},
                       common::Filter::linear, std::vector<std::uint16_t>(numbers));
    };
    EXPECT_NO_THROW(make_16(3, ColorSpace::linear));
    EXPECT_THROW(make_16(2, ColorSpace::linear), common::InputError);
    EXPECT_THROW(make_16(3, ColorSpace::srgb), common::InputError) << "for data alone";
}

}  // namespace
