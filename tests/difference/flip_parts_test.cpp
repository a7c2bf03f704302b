// Tests the parts of FLIP: colours, filters, exposures and the colours of its map.
#include <gtest/gtest.h>

#include <numeric>

#include "common/core/input_error.h"
#include "common/difference/error_map.h"
#include "common/difference/flip.h"
#include "common/difference/flip_colors.h"
#include "common/difference/flip_exposures.h"
#include "common/difference/flip_filters.h"

namespace {

using common::Rgb;
using Pixels = std::vector<Rgb>;

TEST(FlipColors, OfWhiteAndGreyHaveNoColor) {
    for (const float level : {0.0f, 0.001f, 0.18f, 1.0f}) {
        const common::HuntLab lab = common::hunt_lab({level, level, level});
        EXPECT_NEAR(lab.a, 0, 1e-4);
        EXPECT_NEAR(lab.b, 0, 1e-4);
        const common::OpponentColor opponent = common::opponent_color({level, level, level});
        EXPECT_NEAR(opponent.y, 116 * level - 16, 1e-4);
        EXPECT_NEAR(opponent.cx, 0, 1e-4);
        EXPECT_NEAR(opponent.cz, 0, 1e-4);
    }
    EXPECT_NEAR(common::hunt_lab({1, 1, 1}).lightness, 100, 1e-4);
    EXPECT_NEAR(common::hunt_lab({0, 0, 0}).lightness, 0, 1e-4);
    EXPECT_NEAR(common::hunt_lab({0.18418651f, 0.18418651f, 0.18418651f}).lightness, 50,
                1e-4);  // (66 / 116)^3
}

TEST(FlipColors, OfThePrimariesAreTheWellKnownOnes) {
    struct Primary {
        Rgb color;
        double lightness, a, b;
    };
    for (const Primary& known :
         {Primary{{1, 0, 0}, 53.24, 80.09, 67.20}, Primary{{0, 1, 0}, 87.73, -86.18, 83.18},
          Primary{{0, 0, 1}, 32.30, 79.19, -107.86}}) {
        const common::HuntLab lab = common::hunt_lab(known.color);
        EXPECT_NEAR(lab.lightness, known.lightness, 0.02);
        EXPECT_NEAR(lab.a, known.a * known.lightness / 100, 0.02);
        EXPECT_NEAR(lab.b, known.b * known.lightness / 100, 0.02);
    }
}

TEST(FlipColors, CanBeShownAgain) {
    for (const Rgb& color : {Rgb(0, 0, 0), Rgb(1, 1, 1), Rgb(0.2f, 0.9f, 0.1f), Rgb(0.7f, 0, 1)}) {
        const Rgb again = common::displayed_color(common::opponent_color(color));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(again[c], color[c], 1e-5);
    }
    const Rgb beyond = common::displayed_color(common::opponent_color({2, -1, 0.5f}));
    EXPECT_EQ(beyond.x, 1);
    EXPECT_EQ(beyond.y, 0);
}

TEST(FlipColors, AddLightnessToTheDistanceOfColors) {
    EXPECT_FLOAT_EQ(common::hyab_distance({10, 1, 2}, {15, 4, -2}), 10);
    EXPECT_FLOAT_EQ(common::hyab_distance({15, 4, -2}, {10, 1, 2}), 10);
}

double sum_of(const common::Kernel& kernel) {
    return std::accumulate(kernel.weights.begin(), kernel.weights.end(), 0.0);
}

TEST(FlipFilters, KeepWhatIsUniformAndFindOnlyWhatIsNot) {
    const auto contrast = common::contrast_filters(common::flip_pixels_per_degree);
    for (const auto* part : {&contrast.y, &contrast.cx, &contrast.cz_narrow, &contrast.cz_wide}) {
        EXPECT_NEAR(sum_of(part->kernel), 1, 1e-6);
        EXPECT_EQ(part->kernel.radius(), 10);
    }
    EXPECT_EQ(contrast.y.weight, 1);
    EXPECT_EQ(contrast.cx.weight, 1);
    EXPECT_NEAR(contrast.cz_narrow.weight + contrast.cz_wide.weight, 1, 1e-6);
    const auto feature = common::feature_filters(common::flip_pixels_per_degree);
    EXPECT_NEAR(sum_of(feature.gaussian), 1, 1e-6);
    for (const auto* part : {&feature.edge, &feature.point}) {
        EXPECT_NEAR(sum_of(*part), 0, 1e-6);
        double size = 0;
        for (const float weight : part->weights) size += std::abs(weight);
        EXPECT_NEAR(size, 2, 1e-6);
        EXPECT_EQ(part->radius(), 9);
    }
}

TEST(FlipFilters, AreAppliedAlongRowsAndColumns) {
    const common::Kernel horizontal = {{1, 2, 3}}, vertical = {{10, 20, 40, 50, 70}};
    common::Plane dot(7, 6);
    dot.row(3)[4] = 1;
    const common::Plane spread = common::filtered(dot, horizontal, vertical);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 7; ++x) {
            const int i = 4 - x + 1, j = 3 - y + 2;
            const bool within = i >= 0 && i < 3 && j >= 0 && j < 5;
            EXPECT_EQ(spread.row(y)[x], within ? horizontal.weights[i] * vertical.weights[j] : 0)
                << x << ", " << y;
        }
    common::Plane narrow(1, 2);  // smaller than the filter: its border pixels are repeated beyond it
    narrow.values = {1, 3};
    EXPECT_EQ(common::filtered(narrow, horizontal, vertical).values,
              (std::vector<float>{6 * 70 + 18 * 120, 6 * 30 + 18 * 160}));
}

TEST(FlipExposures, ShowBrightestAndMedianJustBelowWhite) {
    const Pixels reference = {{1, 1, 1}, {64, 64, 64}, {2, 2, 2}, {0.5f, 0.5f, 0.5f}, {4, 4, 4}};
    const common::Exposures exposures = common::exposures_for(reference);
    EXPECT_NEAR(common::displayed(reference, exposures.start)[1].x, 0.85, 1e-5);
    EXPECT_NEAR(common::displayed(reference, exposures.stop)[2].y, 0.85, 1e-5);
    EXPECT_NEAR(exposures.stop - exposures.start, 5, 1e-9);
    EXPECT_EQ(exposures.count, 5);
    EXPECT_EQ(exposures.at(0), exposures.start);
    EXPECT_NEAR(exposures.at(4), exposures.stop, 1e-9);
}

TEST(FlipExposures, AreThePublishedEvaluatorsAlsoInOddCases) {
    const common::Exposures uniform = common::exposures_for(Pixels(4, Rgb(1, 1, 1)));
    EXPECT_NEAR(uniform.start, 1.0832973, 1e-5);
    EXPECT_NEAR(uniform.stop, 1.0832973, 1e-5);
    EXPECT_EQ(uniform.count, 2);
    const common::Exposures even =
        common::exposures_for(Pixels{{1, 1, 1}, {10, 10, 10}, {2, 2, 2}, {3, 3, 3}});  // 3 is its median
    EXPECT_NEAR(even.start, -2.2386308, 1e-5);
    EXPECT_NEAR(even.stop, -0.5016654, 1e-5);
    const common::Exposures black = common::exposures_for(Pixels{{0, 0, 0}, {0, 0, 0}, {5, 5, 5}});
    EXPECT_NEAR(black.stop, 24.0832973, 1e-5);
    EXPECT_EQ(black.count, 26);
}

TEST(FlipExposures, RefuseAReferenceThatNoneShows) {
    for (const float value : {0.0f, -1.0f, 1e-40f})
        EXPECT_THROW((void)common::exposures_for(Pixels(4, Rgb(value, value, value))), common::InputError);
    const common::Exposures dim = common::exposures_for(Pixels(4, Rgb(1e-20f, 1e-20f, 1e-20f)));
    EXPECT_EQ(dim.start, dim.stop);
    EXPECT_NEAR(common::displayed(Pixels{{1e-20f, 0, 0}}, dim.start)[0].x, 0.85, 1e-5);
}

TEST(ErrorMap, GrowsBrighterAllTheWay) {
    EXPECT_EQ(common::magma(0), (common::DisplayColor{0, 0, 4}));
    EXPECT_EQ(common::magma(1), (common::DisplayColor{252, 253, 191}));
    EXPECT_EQ(common::magma(0.5f), (common::DisplayColor{183, 55, 121}));
    EXPECT_EQ(common::magma(-1), common::magma(0));
    EXPECT_EQ(common::magma(2), common::magma(1));
    const auto brightness = [](const common::DisplayColor& color) {
        return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    };
    for (int i = 0; i < 100; ++i)
        EXPECT_LT(brightness(common::magma(static_cast<float>(i) / 100)),
                  brightness(common::magma(static_cast<float>(i + 1) / 100)));
}

}  // namespace
