// Tests what two halves tell about bias and noise, on estimators of known bias and noise.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "bench/experiments/fit/carry_on.h"
#include "bench/experiments/fit/estimates.h"
#include "bench/experiments/fit/halves.h"
#include "common/core/input_error.h"
#include "tests/support/statistics.h"

namespace {

using namespace bench::fit;
using common::Rgb;
using tests::count_for;
using tests::Sample;
using tests::z_for;

constexpr Tiling tiling = {8, 8};
constexpr std::uint32_t tiles = 64, points_per_tile = 25, points = tiles * points_per_tile;
constexpr double alpha = 1e-5;  // probability that a test fails by chance

/// Returns the light at a point: half of the points are ten times as bright as the others.
float light_at(std::uint32_t i) {
    return i % 2 == 0 ? 1.0f : 10.0f;
}

const std::vector<std::uint32_t>& tile_of_points() {
    static const std::vector<std::uint32_t> tile = [] {
        std::vector<std::uint32_t> all(points);
        for (std::uint32_t i = 0; i < points; ++i) all[i] = i / points_per_tile;
        return all;
    }();
    return tile;
}

FitPoints fit_points() {
    FitPoints all;
    all.tile = tile_of_points();
    all.tiling = tiling;
    return all;
}

Measure measure() {
    std::vector<Rgb> light(points);
    for (std::uint32_t i = 0; i < points; ++i) light[i] = Rgb(light_at(i));
    return {light, tile_of_points(), tiling};
}

/// Returns the expected weight: 1 / (R^2 + 0.01 (mean R)^2).
double weight_at(std::uint32_t i) {
    return 1 / (std::pow(light_at(i), 2) + 0.01 * 5.5 * 5.5);
}

/// Light with a relative bias in some tiles, and with noise that neighbours share, as texels have it.
struct Synthetic {
    double bias, noise;
    std::uint32_t neighbours = 5;

    [[nodiscard]] double bias_at(std::uint32_t i) const {
        return tile_of_points()[i] % 8 == 0 ? bias * light_at(i) : 0;
    }

    [[nodiscard]] std::vector<Rgb> half(std::mt19937_64& random) const {
        std::normal_distribution<double> normal;
        std::vector<Rgb> answers(points);
        double shared = 0;
        for (std::uint32_t i = 0; i < points; ++i) {
            if (i % neighbours == 0) shared = normal(random);
            answers[i] = Rgb(static_cast<float>(light_at(i) * (1 + noise * shared) + bias_at(i)));
        }
        return answers;
    }

    [[nodiscard]] Halves halves(std::mt19937_64& random) const {
        Halves both;
        both.a = half(random);
        both.b = half(random);
        return both;
    }

    [[nodiscard]] double mean_sq(const std::function<double(std::uint32_t)>& of) const {
        double sum = 0;
        for (std::uint32_t i = 0; i < points; ++i) sum += weight_at(i) * std::pow(of(i), 2);
        return sum / points;
    }
    [[nodiscard]] double bias_sq() const {
        return mean_sq([&](std::uint32_t i) { return bias_at(i); });
    }
    [[nodiscard]] double variance() const {
        return mean_sq([&](std::uint32_t i) { return noise * light_at(i); });
    }
};

TEST(FitEstimate, FindsBiasAndNoiseWithoutBiasOfItsOwn) {
    const Measure by = measure();
    const Synthetic coarse{.bias = 0.2, .noise = 0.3}, fine{.bias = 0, .noise = 0.6, .neighbours = 1};
    std::mt19937_64 random(1);
    Sample bias_sq, variance;
    for (std::uint64_t run = 0; run < 1000; ++run) {
        const Halves halves = coarse.halves(random);
        bias_sq.add(squared_difference(halves, fine.halves(random), by).value);
        variance.add(noise_sq(halves, by));
    }
    const double z = z_for(alpha);
    EXPECT_NEAR(bias_sq.mean(), coarse.bias_sq(), z * bias_sq.standard_error());
    EXPECT_NEAR(variance.mean(), coarse.variance(), z * variance.standard_error());
    EXPECT_LT(bias_sq.standard_error(), 0.1 * coarse.bias_sq()) << "else this says nothing";
}

// The variance that an estimate reports is the true one, or slightly larger. The cases are bias in few tiles,
// bias alone, no bias, and noise that tiles share.

TEST(FitEstimate, KnowsItsOwnSpread) {
    const Measure by = measure();
    const std::uint64_t runs = count_for(2000, 200);
    std::mt19937_64 random(2);
    for (const auto& [bias, neighbours] :
         {std::pair(0.0, 5u), {0.05, 5u}, {0.5, 5u}, {0.05, 2 * points_per_tile}}) {
        SCOPED_TRACE(testing::Message() << bias << ", " << neighbours);
        const Synthetic coarse{.bias = bias, .noise = 0.3, .neighbours = neighbours},
            fine{.bias = 0, .noise = 0.2, .neighbours = 1};
        Sample found, claimed;
        for (std::uint64_t run = 0; run < runs; ++run) {
            const SquareEstimate estimate =
                squared_difference(coarse.halves(random), fine.halves(random), by);
            found.add(estimate.value);
            claimed.add(estimate.variance());
        }
        const double variance = std::pow(found.standard_error(), 2) * static_cast<double>(runs);
        // A variance from n normal values has the standard deviation sqrt(2 / n) times itself.
        const double deviation =
            std::hypot(variance * std::sqrt(2.0 / static_cast<double>(runs)), claimed.standard_error());
        EXPECT_GT(claimed.mean(), variance - z_for(alpha) * deviation);
        EXPECT_LT(claimed.mean(), 1.6 * variance) << "the largest of three, with few tiles that count";
    }
}

// The variance over the points that a grid happens to hit must be separated from that of the noise.

TEST(FitEstimate, KnowsHowMuchHangsOnItsPoints) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    constexpr double share = 0.02, crease = 0.5, noise = 0.05;  // fraction of points, and relative errors
    Sample value, claimed;
    const std::uint64_t runs = count_for(1000, 200);
    const std::vector<Rgb> ones(points, Rgb(1));
    const Measure by(ones, tile_of_points(), tiling);
    for (std::uint64_t run = 0; run < runs; ++run) {
        std::vector<Rgb> a, b;
        for (std::uint32_t i = 0; i < points; ++i) {
            const double bias = std::generate_canonical<double, 53>(random) < share ? crease : 0;
            a.emplace_back(static_cast<float>(1 + bias + noise * normal(random)));
            b.emplace_back(static_cast<float>(1 + bias + noise * normal(random)));
        }
        const SquareEstimate found = squared_difference({a, b}, {ones, ones}, by);
        value.add(found.value);
        claimed.add(found.sampling_variance + found.variance());
        EXPECT_GT(found.sampling_variance, 4 * found.variance());
    }
    const double variance = std::pow(value.standard_error(), 2) * static_cast<double>(runs);
    const double deviation =
        std::hypot(variance * std::sqrt(2.0 / static_cast<double>(runs)), claimed.standard_error());
    EXPECT_GT(claimed.mean(), variance - z_for(alpha) * deviation);
    EXPECT_LT(claimed.mean(), 1.2 * variance + z_for(alpha) * deviation);
}

// deviation() bounds the difference between a run's squared error and a pilot's estimate of it.

TEST(FitEstimate, DeviationBoundsWhatRunsDifferFromEstimates) {
    const Measure by = measure();
    const Synthetic coarse{.bias = 0.3, .noise = 0.3}, fine{.bias = 0, .noise = 0.2, .neighbours = 1};
    std::vector<Rgb> truth(points);
    for (std::uint32_t i = 0; i < points; ++i) truth[i] = Rgb(light_at(i));
    std::mt19937_64 random(3);
    for (const double times : {0.0625, 0.25, 1.0, 16.0}) {  // hits of the run over those of the pilot's half
        SCOPED_TRACE(times);
        const Synthetic run_of{.bias = coarse.bias, .noise = coarse.noise / std::sqrt(times)};
        Sample difference, claimed;
        for (std::uint64_t run = 0; run < 1000; ++run) {
            const Halves halves = coarse.halves(random);
            const SquareEstimate bias_sq = squared_difference(halves, fine.halves(random), by);
            const ErrorModel model{.pilot_hits = 1000,
                                   .noise_sq = noise_sq(halves, by),
                                   .blur_sq = std::max(0.0, bias_sq.value),
                                   .truncation_sq = 0,
                                   .bias_variance = bias_sq.variance(),
                                   .spread_variance = variance_about(halves, truth, by),
                                   .noise_variance = most_noise_variance(halves, by)};
            const std::vector<Rgb> answers = run_of.half(random);
            double error_sq = 0;
            for (std::uint32_t i = 0; i < points; ++i)
                error_sq += weight_at(i) * std::pow(answers[i].x - light_at(i), 2) / points;
            difference.add(error_sq - model.error_sq(1000 * times));
            claimed.add(model.deviation(1000 * times));
        }
        const double found = difference.standard_error() * std::sqrt(static_cast<double>(difference.count()));
        EXPECT_NEAR(difference.mean(), 0, z_for(alpha) * difference.standard_error());
        EXPECT_LT(found, 1.1 * claimed.mean());
        EXPECT_GT(found, 0.5 * claimed.mean()) << "an idle bound costs hits";
    }
}

TEST(FitEstimate, RefusesToBeRelativeToNothing) {
    const std::vector<Rgb> black(points, Rgb(0));
    EXPECT_THROW(Measure(black, tile_of_points(), tiling), common::InputError);
}

// Tests with a truth that is noisy but unbiased.

/// All candidates are measured with a million hits per half.
class FitTruth : public testing::Test {
  protected:
    std::vector<Candidate> candidates = {{CandidateKind::light_map, "L4/radiance", "own", 1024},
                                         {CandidateKind::photon_radius, "disc", "r", 0.01},
                                         {CandidateKind::photon_share, "disc", "k", 64e-6}};

    /// Makes a sample without noise.
    [[nodiscard]] static PilotSample sample_of(const std::vector<Rgb>& answers) {
        PilotSample sample;
        sample.halves = {answers, answers};
        sample.cost.hits = 1e6;
        return sample;
    }

    [[nodiscard]] static std::vector<Rgb> light() {
        std::vector<Rgb> answers(points);
        for (std::uint32_t i = 0; i < points; ++i) answers[i] = Rgb(light_at(i));
        return answers;
    }

    /// Returns light that is too bright by the fraction `share` in the first half of the tiles.
    [[nodiscard]] static std::vector<Rgb> too_bright(float share) {
        std::vector<Rgb> answers = light();
        for (std::uint32_t i = 0; i < points / 2; ++i) answers[i] *= 1 + share;
        return answers;
    }

    /// Returns a truth with independent relative noise at each point.
    [[nodiscard]] static Halves noisy_truth(float noise, std::uint64_t seed) {
        std::mt19937_64 random(seed);
        const Synthetic truth{.bias = 0, .noise = noise, .neighbours = 1};
        return truth.halves(random);
    }

    [[nodiscard]] Estimates estimates_by(const std::vector<PilotSample>& samples, const Halves& truth) const {
        return estimate_errors(candidates, samples, truth, fit_points(), {}, 1).value();
    }
};

TEST_F(FitTruth, MeasuresEachKindOfMapWhateverTheOthersBlur) {
    const std::vector<PilotSample> samples = {sample_of(too_bright(0.3f)), sample_of(too_bright(0.05f)),
                                              sample_of(too_bright(0.2f))};
    Sample light_map, photon_map;
    double claimed = 0;
    constexpr std::uint64_t runs = 60;
    for (std::uint64_t run = 0; run < runs; ++run) {
        const Estimates found = estimates_by(samples, noisy_truth(0.1f, run));
        light_map.add(found.model[0]->bias_sq());
        photon_map.add(found.model[1]->bias_sq());
        claimed += found.model[1]->bias_variance / runs;
    }
    const auto true_bias_sq = [](double share) {
        double sum = 0;
        for (std::uint32_t i = 0; i < points / 2; ++i)
            sum += weight_at(i) * std::pow(share * light_at(i), 2) / points;
        return sum;
    };
    const double z = z_for(alpha);
    constexpr double of_weights = 0.06;  // the denominators of errors are known to a few per cent
    EXPECT_NEAR(light_map.mean(), true_bias_sq(0.3),
                z * light_map.standard_error() + of_weights * true_bias_sq(0.3));
    EXPECT_NEAR(photon_map.mean(), true_bias_sq(0.05),
                z * photon_map.standard_error() + of_weights * true_bias_sq(0.05));
    const double spread = photon_map.standard_error() * std::sqrt(static_cast<double>(runs));
    EXPECT_LT(spread, 1.5 * std::sqrt(claimed)) << "it knows what the noise of the paths leaves open";
}

TEST_F(FitTruth, WhatAllMapsReadTooBrightIsFound) {
    const std::vector<PilotSample> samples(3, sample_of(too_bright(0.2f)));
    const Estimates found = estimates_by(samples, noisy_truth(0.05f, 1));
    for (const auto& model : found.model) EXPECT_NEAR(std::sqrt(model->bias_sq()), 0.2 / std::sqrt(2), 0.02);
}

TEST_F(FitTruth, ErrorsAreRelativeToTheLightWhereNoMapShowsIt) {
    std::vector<Rgb> blurred = light();
    for (std::uint32_t i = 0; i < points_per_tile; ++i) blurred[i] = Rgb(10);  // where half are 1
    const std::vector<PilotSample> samples(3, sample_of(blurred));
    const Estimates found = estimates_by(samples, noisy_truth(0.02f, 1));
    double bias_sq = 0;
    for (std::uint32_t i = 0; i < points_per_tile; ++i)
        bias_sq += weight_at(i) * std::pow(10 - light_at(i), 2) / points;
    EXPECT_NEAR(found.model[0]->bias_sq() / bias_sq, 1, 0.05) << "by blurred light it would be a seventh";
}

TEST_F(FitTruth, WithoutPathsTheFinestPhotonsStandInForIt) {
    candidates.push_back({CandidateKind::photon_share, "disc", "k", 8e-6});
    const std::vector<PilotSample> samples = {sample_of(too_bright(0.3f)), sample_of(too_bright(0.2f)),
                                              sample_of(too_bright(0.1f)), sample_of(light())};
    const Estimates found = estimates_by(samples, {});
    EXPECT_EQ(found.model[3]->bias_sq(), 0);
    EXPECT_GT(found.model[0]->bias_sq(), found.model[1]->bias_sq());
    EXPECT_GT(found.model[1]->bias_sq(), found.model[2]->bias_sq());
}

TEST(FitEstimate, DoubtIsOfTheEstimateAloneNotOfTheRun) {
    const ErrorModel model{.pilot_hits = 1e6,
                           .noise_sq = 0.01,
                           .bias_variance = 4e-8,
                           .spread_variance = 1e-6,
                           .noise_variance = 1e-6};
    EXPECT_DOUBLE_EQ(model.doubt(1e9), 2e-4) << "many hits leave what is not known of the bias";
    EXPECT_DOUBLE_EQ(model.doubt(1e6), 2e-4);
    EXPECT_DOUBLE_EQ(model.doubt(0.5e6), std::sqrt(4e-8 + 2e-6));
    EXPECT_GT(model.deviation(1e6), model.doubt(1e6));
}

// Tests of the hits for a target.

TEST(FitHits, SolveTheModel) {
    const ErrorModel model{.pilot_hits = 1e6, .noise_sq = 0.04, .blur_sq = 0.0004, .truncation_sq = 0.0005};
    // 0.05^2 = 0.0009 + 0.04 * 1e6 / N
    EXPECT_NEAR(hits_for(model, 0.05, 2).value(), 0.04e6 / (0.0025 - 0.0009), 1);
    EXPECT_FALSE(hits_for(model, 0.03, 0)) << "the bias alone is 0.03";
    EXPECT_TRUE(hits_for(model, 0.0301, 0));
}

TEST(FitHits, DoubtTakesMoreOrForbids) {
    ErrorModel model{.pilot_hits = 1e6, .noise_sq = 0.04, .blur_sq = 0.0009};
    const double certain = hits_for(model, 0.05, 1).value();
    model.spread_variance = 1e-8;
    const double spread = hits_for(model, 0.05, 1).value();
    EXPECT_GT(spread, certain);
    EXPECT_NEAR(model.error_sq(spread) + model.deviation(spread), 0.0025, 1e-9);
    EXPECT_NEAR(hits_for(model, 0.05, 0).value(), certain, 1e-3 * certain);
    const double with_bias_alone = hits_for(model, 0.4, 1).value();
    EXPECT_LT(with_bias_alone, 1e6) << "else its noise does not count";
    model.noise_variance = 1e-8;
    EXPECT_GT(hits_for(model, 0.4, 1), with_bias_alone);
    model.bias_variance = std::pow(0.0016, 2);
    EXPECT_FALSE(hits_for(model, 0.05, 1.01));
    EXPECT_TRUE(hits_for(model, 0.05, 0.9));
}

TEST(FitHits, OfAnAdaptiveMapAreThePilots) {
    const ErrorModel model{.pilot_hits = 1e6, .noise_sq = 0.0016, .blur_sq = 0.0009, .at_pilot_alone = true};
    EXPECT_EQ(hits_for(model, 0.051, 0), 1e6);
    EXPECT_FALSE(hits_for(model, 0.049, 0)) << "whatever more hits would do";
}

// Tests of the extrapolation along a chain.

TEST(FitChain, FinerMapsBlurLessAndAreNoisier) {
    const ErrorModel coarse{.pilot_hits = 1e6, .noise_sq = 0.01, .blur_sq = 0.02, .truncation_sq = 0.003};
    const ErrorModel fine = carried_on(coarse, 1.0 / 32, 1.0 / 64);
    EXPECT_DOUBLE_EQ(fine.noise_sq, 0.04);
    EXPECT_DOUBLE_EQ(fine.blur_sq, 0.01);
    EXPECT_DOUBLE_EQ(fine.truncation_sq, 0.003);
    EXPECT_EQ(fine.pilot_hits, 1e6);
}

/// Returns four candidates of one chain and two of another.
std::vector<Candidate> two_chains() {
    std::vector<Candidate> all;
    for (const double texels : {1024.0, 4096.0, 16384.0, 65536.0})
        all.push_back({CandidateKind::light_map, "L2/radiance", "own", texels});
    for (const double texels : {1024.0, 4096.0})
        all.push_back({CandidateKind::light_map, "L2/radiance", "surface4", texels});
    return all;
}

TEST(FitChain, TakesTheLeastUpperBound) {
    const std::vector<Candidate> candidates = two_chains();
    std::vector<std::optional<ErrorModel>> model(candidates.size());
    model[0] = {.pilot_hits = 1e5, .noise_sq = 0.1, .blur_sq = 0.08, .bias_variance = 1e-8};
    model[1] = {.pilot_hits = 1e5, .noise_sq = 0.3, .blur_sq = 0.03, .bias_variance = 1e-8};  // is better
    model[2] = {.pilot_hits = 1e5, .noise_sq = 1.1, .blur_sq = 0.01, .bias_variance = 1e-2};  // says nothing
    carry_on(candidates, 1, model);
    EXPECT_EQ(model[0]->blur_sq, 0.08);
    EXPECT_EQ(model[1]->blur_sq, 0.03);
    EXPECT_DOUBLE_EQ(model[2]->blur_sq, 0.015) << "of the coarser one";
    EXPECT_EQ(model[2]->noise_sq, 1.1) << "its own";
    ASSERT_TRUE(model[3]);
    EXPECT_DOUBLE_EQ(model[3]->blur_sq, 0.0075);
    EXPECT_DOUBLE_EQ(model[3]->noise_sq, 4.4);
    EXPECT_FALSE(model[4]) << "another chain";
    EXPECT_FALSE(model[5]);
}

/// A map too coarse to show anything of the light has its whole variance as blur, and so has one of half its
/// width.
TEST(FitChain, WhatIsMeasuredIsNotContradictedByTheLaw) {
    const std::vector<Candidate> candidates = two_chains();
    std::vector<std::optional<ErrorModel>> model(candidates.size());
    model[0] = {.pilot_hits = 1e5, .blur_sq = 0.3, .bias_variance = 1e-8};
    model[1] = {.pilot_hits = 1e5, .blur_sq = 0.29, .bias_variance = 1e-6};
    model[2] = {.pilot_hits = 1e5, .blur_sq = 0.2, .bias_variance = 1e-2};
    carry_on(candidates, 1, model);
    EXPECT_EQ(model[1]->blur_sq, 0.29) << "not 0.15";
    EXPECT_DOUBLE_EQ(model[2]->blur_sq, 0.145) << "may be that little";
}

}  // namespace
