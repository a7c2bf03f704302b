// What two halves say of bias and noise, on estimators whose bias and noise are known.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
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
constexpr double alpha = 1e-5;  // of a test to fail by accident

/// By place: half of the points are ten times as bright as the others.
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

/// The expected weight: 1 / (R^2 + 0.01 (mean R)^2).
double weight_at(std::uint32_t i) {
    return 1 / (std::pow(light_at(i), 2) + 0.01 * 5.5 * 5.5);
}

/// Light plus a relative bias in the tiles that have one, and noise that neighbours share: as texels do.
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

// The spread that an estimate claims is the one it has, or a little more, with bias in few tiles, with bias
// alone and without any, and with noise that tiles share.

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
        // Of a variance from n normal values: sqrt(2 / n) of it.
        const double deviation =
            std::hypot(variance * std::sqrt(2.0 / static_cast<double>(runs)), claimed.standard_error());
        EXPECT_GT(claimed.mean(), variance - z_for(alpha) * deviation);
        EXPECT_LT(claimed.mean(), 1.6 * variance) << "the largest of three, with few tiles that count";
    }
}

// deviation() bounds what a run's squared error differs from a pilot's estimate of it.

TEST(FitEstimate, DeviationBoundsWhatRunsDifferFromEstimates) {
    const Measure by = measure();
    const Synthetic coarse{.bias = 0.3, .noise = 0.3}, fine{.bias = 0, .noise = 0.2, .neighbours = 1};
    std::vector<Rgb> truth(points);
    for (std::uint32_t i = 0; i < points; ++i) truth[i] = Rgb(light_at(i));
    std::mt19937_64 random(3);
    for (const double times : {0.0625, 0.25, 1.0, 16.0}) {  // hits of the run for each of the pilot's half
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

TEST(FitEstimate, AddsAndScalesEstimates) {
    SquareEstimate sum{.value = 1, .tile_difference = {1, -2}, .tiling = {2, 1}};
    sum += SquareEstimate{.value = 2, .tile_difference = {2, 2}, .tiling = {2, 1}}.scaled(0.5);
    EXPECT_EQ(sum.value, 2);
    EXPECT_EQ(sum.tile_difference, (std::vector<double>{2, -1}));
    EXPECT_EQ(sum.variance(), 5);
    sum += {};
    EXPECT_EQ(sum.variance(), 5);
}

TEST(FitEstimate, RefusesToBeRelativeToNothing) {
    const std::vector<Rgb> black(points, Rgb(0));
    EXPECT_THROW(Measure(black, tile_of_points(), tiling), common::InputError);
}

// What stands in for the truth.

/// Squared biases by their own estimates of three maps that answer without noise, each with four times the
/// texels of the one before.
std::vector<double> estimated_bias_sq(const std::vector<std::vector<Rgb>>& answers) {
    const std::vector<Candidate> candidates = {{CandidateKind::light_map, "L4/radiance", "own", 1024},
                                               {CandidateKind::light_map, "L4/radiance", "own", 4096},
                                               {CandidateKind::light_map, "L4/radiance", "own", 16384},
                                               {CandidateKind::photon_share, "disc", "k", 64e-6}};
    std::vector<PilotSample> samples(candidates.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::vector<Rgb>& seen = answers[i == 3 ? 1 : i];
        samples[i].halves = {seen, seen};
        samples[i].cost.hits = 1e6;
    }
    const auto estimates = estimate_errors(candidates, samples, fit_points(), 0, 1);
    EXPECT_EQ(estimates->finest.candidate, 2u);
    std::vector<double> bias_sq;
    for (std::size_t i = 0; i < 3; ++i) bias_sq.push_back(estimates->model[i]->bias_sq());
    return bias_sq;
}

/// Light of 1, so that squares are relative, with detail in octaves: texels of each size miss all finer ones.
/// The first octave beyond the finest map has 1e-4, and each has `falls_by` times less than the one before,
/// up to the last. Squared biases by their own estimates over what they are, from the coarsest map.
std::vector<double> estimated_over_true_with_detail(double falls_by) {
    constexpr int coarser = 2, finer = 3;  // octaves between the maps, and beyond the finest
    std::mt19937_64 random(3);
    std::normal_distribution<float> normal;
    std::vector<std::vector<Rgb>> answers = {std::vector<Rgb>(points, Rgb(1, 1, 1))};
    std::vector<double> energy;
    for (int octave = -coarser; octave < finer; ++octave) {
        const auto amplitude = static_cast<float>(std::sqrt(1e-4 * std::pow(falls_by, -octave)));
        std::vector<Rgb> seen = answers.back();
        double sum_sq = 0;
        for (Rgb& value : seen) {
            const float detail = amplitude * normal(random);
            value += Rgb(1, 1, 1) * detail;
            sum_sq += detail * detail;
        }
        answers.push_back(seen);
        energy.push_back(sum_sq / points);
    }
    std::vector<double> ratio = estimated_bias_sq(answers);
    for (std::size_t i = 0; i < ratio.size(); ++i)
        ratio[i] /= std::accumulate(energy.begin() + static_cast<std::ptrdiff_t>(i), energy.end(), 0.0);
    return ratio;
}

TEST(FitTruth, BlurThatFallsAsItsWidthIsKnown) {
    const std::vector<double> ratio = estimated_over_true_with_detail(2);
    EXPECT_NEAR(ratio[2], 1.5 * 8 / 7, 0.2) << "7 of 8 parts are there";
    EXPECT_NEAR(ratio[1], 3.5 / 2 * 16 / 15, 0.2) << "what the finest map blurs is counted twice and a half";
    EXPECT_NEAR(ratio[0], 5.5 / 4 * 32 / 31, 0.2);
}

TEST(FitTruth, BlurThatHardlyFallsIsNotOverlooked) {
    const double found = estimated_over_true_with_detail(1.2)[2];
    EXPECT_GT(found, 1) << "three octaves of three times what the finest map sees";
    EXPECT_LT(found, 3);
}

/// An edge in light of 1 that a box of this width blurs; the image is 1 wide.
std::vector<Rgb> blurred_edge(float width) {
    constexpr float step = 0.01f;
    std::vector<Rgb> answers;
    for (std::uint32_t i = 0; i < points; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) / points - 0.5f;
        answers.push_back(Rgb(1, 1, 1) * (1 + step * std::clamp(x / width + 0.5f, 0.0f, 1.0f)));
    }
    return answers;
}

TEST(FitTruth, OfBlurredEdgesAQuarterIsMissedAtMost) {
    constexpr float width = 0.05f;
    const std::vector<double> bias_sq =
        estimated_bias_sq({blurred_edge(4 * width), blurred_edge(2 * width), blurred_edge(width)});
    const double blur_sq = width / 12 * 1e-4;  // of the finest: the integral of (step (1/2 - x / width))^2
    constexpr double of_weights = 0.03;        // 1 / (R^2 + eps), R from 1 to 1.01
    EXPECT_NEAR(bias_sq[2] / blur_sq, 3.0 / 4, of_weights);
    EXPECT_NEAR(bias_sq[1] / (2 * blur_sq), 7.0 / 8, of_weights);
    EXPECT_NEAR(bias_sq[0] / (4 * blur_sq), 31.0 / 32, of_weights);
}

/// By texels that are finer and finer and each see the light through more noise; and by a photon map of much
/// bias and no noise.
std::vector<PilotSample> samples_of_finer_maps(double noise_sq_of_finest) {
    std::vector<PilotSample> samples(5);
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    const std::vector<double> bias_sq = {0.0064, 0.0016, 0.0004, 0.0001, 0.0025};
    for (std::size_t m = 0; m < samples.size(); ++m) {
        const double noise =
            m == 4 ? 0 : std::sqrt(noise_sq_of_finest * std::pow(4, static_cast<int>(m) - 3));
        const auto half = [&] {
            std::vector<Rgb> answers;
            for (std::uint32_t i = 0; i < points; ++i) {
                const double bias = (i % 2 == 0 ? 1 : -1) * std::sqrt(bias_sq[m]);
                answers.emplace_back(static_cast<float>(1 + bias + noise * normal(random)));
            }
            return answers;
        };
        samples[m].halves = {half(), half()};
        samples[m].cost.hits = 1e6;
    }
    return samples;
}

TEST(FitTruth, IsNoFinerThanWhatIsWantedCanBeMeasuredBy) {
    const std::vector<Candidate> candidates = {{CandidateKind::light_map, "L4/radiance", "own", 1024},
                                               {CandidateKind::light_map, "L4/radiance", "own", 4096},
                                               {CandidateKind::light_map, "L4/radiance", "own", 16384},
                                               {CandidateKind::light_map, "L4/radiance", "own", 65536},
                                               {CandidateKind::photon_share, "disc", "k", 64e-6}};
    const std::vector<PilotSample> samples = samples_of_finer_maps(0.003);
    const auto by_itself = estimate_errors(candidates, samples, fit_points(), 0, 1);
    const auto for_the_photon_map = estimate_errors(candidates, samples, fit_points(), 0.07, 1);
    EXPECT_EQ(by_itself->finest.candidate, 3u) << "little noise beside its own blur";
    EXPECT_EQ(for_the_photon_map->finest.candidate, 2u);
    EXPECT_LT(for_the_photon_map->model[4]->bias_variance, by_itself->model[4]->bias_variance);
    // All err in the same points by 5, 2 and 4 parts in 100: (5 - 2)^2 + (5 - 2) (4 - 2) + 3/2 (4 - 2)^2.
    EXPECT_NEAR(for_the_photon_map->model[4]->bias_sq(), 0.0021,
                z_for(alpha) * std::sqrt(for_the_photon_map->model[4]->bias_variance));
}

// Hits for a target.

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

// Along a chain.

TEST(FitChain, FinerMapsBlurLessAndAreNoisier) {
    const ErrorModel coarse{.pilot_hits = 1e6, .noise_sq = 0.01, .blur_sq = 0.02, .truncation_sq = 0.003};
    const ErrorModel fine = carried_on(coarse, 1.0 / 32, 1.0 / 64);
    EXPECT_DOUBLE_EQ(fine.noise_sq, 0.04);
    EXPECT_DOUBLE_EQ(fine.blur_sq, 0.01);
    EXPECT_DOUBLE_EQ(fine.truncation_sq, 0.003);
    EXPECT_EQ(fine.pilot_hits, 1e6);
}

/// Four candidates of one chain, two of another.
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

/// A map that shows nothing of the light has all of its variance as blur, and so has one of half its width.
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
