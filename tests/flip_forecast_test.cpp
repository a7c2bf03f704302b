// FLIP forecast from two halves, beside FLIP of runs.
#include "bench/fit/flip_forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/difference/flip.h"

namespace {

using namespace bench::fit;
using common::Rgb;

constexpr std::uint32_t width = 48, height = 27, pixels = width * height, tiles = 9;
constexpr double pilot_hits = 1e6;

/// A picture of known truth, and a map with a known bias and noise in proportion to the light, W/m^2.
class FlipForecasts : public testing::Test {
  protected:
    FitPoints points;
    SelfEstimates estimates;  ///< the truth stands in for the best answers
    std::mt19937_64 random{1};

    FlipForecasts() {
        points.tiling = {tiles, 1};
        points.width = width;
        points.height = height;
        points.point.resize(pixels);
        for (std::uint32_t p = 0; p < pixels; ++p) {
            points.pixel.push_back(p);
            points.tile.push_back(p % tiles);
            const float x = static_cast<float>(p % width) / width, y = static_cast<float>(p) / pixels;
            estimates.best_answers.push_back(Rgb(1 + x, 1 + 0.5f * y, 1.5f - 0.5f * x));
        }
    }

    /// Waves as wide as several pixels: what blur looks like.
    [[nodiscard]] float bias_at(std::uint32_t pixel, double bias) const {
        return static_cast<float>(bias * std::sqrt(2) * std::sin(0.5 * (pixel % width) + 0.3));
    }

    [[nodiscard]] std::vector<Rgb> run(double bias, double noise, double hits) {
        std::normal_distribution<float> normal(0, static_cast<float>(noise * std::sqrt(pilot_hits / hits)));
        std::vector<Rgb> answers = estimates.best_answers;
        for (std::uint32_t p = 0; p < pixels; ++p) answers[p] *= 1 + bias_at(p, bias) + normal(random);
        return answers;
    }

    [[nodiscard]] PilotSample sample(double bias, double noise) {
        PilotSample sample;
        sample.halves = {run(bias, noise, pilot_hits), run(bias, noise, pilot_hits)};
        sample.cost.hits = pilot_hits;
        return sample;
    }

    [[nodiscard]] double flip_of(std::span<const Rgb> answers) const {
        return common::flip_mean(common::flip_map(answers, estimates.best_answers, width, height));
    }

    /// Mean over runs.
    [[nodiscard]] double flip_of_runs(double bias, double noise, double hits) {
        constexpr int runs = 8;
        double sum = 0;
        for (int i = 0; i < runs; ++i) sum += flip_of(run(bias, noise, hits));
        return sum / runs;
    }

    [[nodiscard]] NeededHits needed(double bias, double noise, double target, bool adaptive = false) {
        const std::vector<PilotSample> samples = {sample(bias, noise)};
        estimates.model = {ErrorModel{.pilot_hits = pilot_hits,
                                      .noise_sq = noise * noise,
                                      .blur_sq = bias * bias,
                                      .at_pilot_alone = adaptive}};
        return needed_by_flip(estimates, samples, points, {.target = target, .metric = Metric::flip}).front();
    }
};

/// FLIP sees a bias and noise of the same square differently: the forecast must have both where they are.
TEST_F(FlipForecasts, AreThoseOfRuns) {
    constexpr double within = 0.1;
    for (const auto& [bias, noise] : {std::pair(0.0, 0.2), std::pair(0.1, 0.0), std::pair(0.1, 0.2)})
        for (const double hits : {0.25e6, 1e6, 16e6}) {
            const double forecast =
                FlipForecast(points, estimates).flip(sample(bias, noise), bias * bias, hits);
            const double truth = flip_of_runs(bias, noise, hits);
            EXPECT_NEAR(forecast / truth, 1, within) << bias << ", " << noise << ", " << hits << " hits";
        }
}

TEST_F(FlipForecasts, NothingIsLeftOfNoiseAlone) {
    EXPECT_EQ(
        FlipForecast(points, estimates).flip(sample(0, 0.2), 0, std::numeric_limits<double>::infinity()), 0);
}

TEST_F(FlipForecasts, NeededHitsAreThoseOfRuns) {
    const double target = flip_of_runs(0.05, 0.2, 8e6);
    const NeededHits found = needed(0.05, 0.2, target);
    ASSERT_TRUE(found.sure);
    // The pilot's noise hides the bias: a tenth of it, by the square.
    EXPECT_NEAR(flip_of_runs(0.05, 0.2, *found.sure) / target, 1, 0.2);
    EXPECT_NEAR(found.expected.value(), target, 0.1 * target);
    EXPECT_LT(found.without_noise, target);
}

TEST_F(FlipForecasts, BiasForbidsTargets) {
    const NeededHits found = needed(0.2, 0.2, 0.5 * flip_of_runs(0.2, 0, 1e6));
    EXPECT_FALSE(found.sure);
    EXPECT_FALSE(found.least);
    EXPECT_GT(found.without_noise, 0);
}

TEST_F(FlipForecasts, AdaptiveMapsHaveThePilotsHitsOrNone) {
    const double flip = flip_of_runs(0.05, 0.2, pilot_hits);
    EXPECT_EQ(needed(0.05, 0.2, 1.2 * flip, true).sure, pilot_hits);
    EXPECT_FALSE(needed(0.05, 0.2, 0.8 * flip, true).sure);
    EXPECT_GT(needed(0.05, 0.2, 0.8 * flip, true).least.value(), pilot_hits) << "more hits might do";
}

TEST_F(FlipForecasts, KnowNothingOfWhatIsNoiseForTheMostPart) {
    const NeededHits found = needed(0, 1, 0.1);
    EXPECT_FALSE(found.sure);
    EXPECT_EQ(found.least, 4 * pilot_hits) << "a larger pilot may tell";
}

TEST_F(FlipForecasts, KnowNothingOfWhatWasNotMeasured) {
    estimates.model = {std::nullopt};
    const std::vector<PilotSample> samples(1);
    EXPECT_FALSE(needed_by_flip(estimates, samples, points, {.target = 0.1})[0].least);
}

}  // namespace
