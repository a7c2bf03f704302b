#include "bench/fit/flip_forecast.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "common/difference/flip.h"

namespace bench::fit {
namespace {

using common::Rgb;

/// The hits at which FLIP falls to the target lie between these shares of the pilot's, or are not looked for.
/// Noise of far fewer than the pilot's is none that could be drawn from its halves.
constexpr double fewest = 0.25, most = 4096;
constexpr int steps = 8;  // of the bisection: to a factor of (most / fewest)^(1 / 2^8), 1.04

/// Of one half, relative. Noise of less than four photons is rare bright pixels among black ones: a draw of
/// it from two halves shows most pixels right.
constexpr double most_noise_sq = 0.25;

/// Pixels away from the middle: so that a quarter of the bias's square is left of noise that differs from
/// pixel to pixel.
int reach_for(double noise_sq, double bias_sq) {
    constexpr int most_reach = 4;
    int reach = 0;
    while (reach < most_reach && noise_sq > bias_sq / 4 * (2 * reach + 1) * (2 * reach + 1)) ++reach;
    return reach;
}

std::optional<double> hits_for_flip(const FlipForecast& forecast, const PilotSample& sample, double bias_sq,
                                    double target) {
    const double pilot = sample.cost.hits;
    const std::vector<Rgb> bias = forecast.shown_bias(sample, bias_sq);
    const auto meets = [&](double hits) { return forecast.flip(sample, bias, hits) <= target; };
    if (!meets(most * pilot)) return std::nullopt;
    double low = std::log(fewest * pilot), high = std::log(most * pilot);
    for (int step = 0; step < steps; ++step) {
        const double middle = (low + high) / 2;
        (meets(std::exp(middle)) ? high : low) = middle;
    }
    return std::exp(high);
}

/// Of a map whose blocks change with its hits: no more is known than what it showed at the pilot's.
NeededHits needed_at_pilot(const FlipForecast& forecast, const PilotSample& sample, const ErrorModel& model,
                           const FitGoal& goal) {
    const double pilot = sample.cost.hits;
    const double bad = forecast.flip(sample, std::max(0.0, model.upper_bias_sq(z_of(goal, model))), pilot);
    const double likely = forecast.flip(sample, model.bias_sq(), pilot);
    const auto if_met = [&](double flip) {
        return flip <= goal.target ? std::optional(pilot) : std::nullopt;
    };
    return {.sure = if_met(bad),
            .likely = if_met(likely),
            .least = pilot * std::max(1.0, likely * likely / (goal.target * goal.target)),
            .expected = likely,
            .without_noise = bad};
}

NeededHits needed_of(const FlipForecast& forecast, const PilotSample& sample, const ErrorModel& model,
                     const FitGoal& goal) {
    if (model.noise_sq > most_noise_sq) {
        NeededHits unknown;
        unknown.least = model.pilot_hits * model.noise_sq / most_noise_sq;
        return unknown;
    }
    if (model.at_pilot_alone) return needed_at_pilot(forecast, sample, model, goal);
    const double upper = std::max(0.0, model.upper_bias_sq(goal.z)),
                 lower = std::max(0.0, model.lower_bias_sq(goal.z));
    NeededHits needed;
    needed.least = hits_for_flip(forecast, sample, lower, goal.target);
    needed.without_noise = forecast.flip(sample, upper, std::numeric_limits<double>::infinity());
    if (!needed.least) return needed;
    needed.likely = hits_for_flip(forecast, sample, model.bias_sq(), goal.target);
    needed.sure = hits_for_flip(forecast, sample, upper, goal.target);
    if (needed.sure) needed.expected = forecast.flip(sample, model.bias_sq(), *needed.sure);
    return needed;
}

}  // namespace

FlipForecast::FlipForecast(const FitPoints& points, const SelfEstimates& estimates)
    : points_(points),
      estimates_(estimates),
      measure_(estimates.best_answers, points.tile, points.tiling),
      present_(std::size_t{points.width} * points.height),
      reference_(picture_of(estimates.best_answers)),
      exposures_(common::exposures_for(estimates.best_answers)) {
    for (const std::uint32_t pixel : points.pixel) present_[pixel] = 1;
}

std::vector<Rgb> FlipForecast::picture_of(std::span<const Rgb> answers) const {
    std::vector<Rgb> picture(std::size_t{points_.width} * points_.height, Rgb(0, 0, 0));
    for (std::size_t i = 0; i < answers.size(); ++i) picture[points_.pixel[i]] = answers[i];
    return picture;
}

std::vector<Rgb> FlipForecast::averaged(std::span<const Rgb> values, int reach) const {
    const std::vector<Rgb> picture = picture_of(values);
    const auto width = static_cast<int>(points_.width), height = static_cast<int>(points_.height);
    std::vector<Rgb> means(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int x = static_cast<int>(points_.pixel[i]) % width,
                  y = static_cast<int>(points_.pixel[i]) / width;
        Rgb sum(0, 0, 0);
        float count = 0;
        for (int row = std::max(y - reach, 0); row <= std::min(y + reach, height - 1); ++row)
            for (int column = std::max(x - reach, 0); column <= std::min(x + reach, width - 1); ++column) {
                const auto pixel = static_cast<std::size_t>(row * width + column);
                sum += picture[pixel];
                count += present_[pixel];
            }
        means[i] = sum / count;
    }
    return means;
}

std::vector<Rgb> FlipForecast::shown_bias(const PilotSample& sample, double bias_sq) const {
    std::vector<Rgb> bias = mean_of(sample.halves);
    for (std::size_t i = 0; i < bias.size(); ++i) bias[i] -= estimates_.best_answers[i];
    bias = averaged(bias, reach_for(noise_sq(sample.halves, measure_) / 2, bias_sq));
    const double shown_sq = mean_square(bias, measure_);
    const auto scale = static_cast<float>(shown_sq > 0 ? std::sqrt(bias_sq / shown_sq) : 0);
    for (Rgb& shown : bias) shown *= scale;
    return bias;
}

double FlipForecast::flip(const PilotSample& sample, std::span<const Rgb> shown_bias, double hits) const {
    const std::vector<Rgb>& best = estimates_.best_answers;
    const auto noise = static_cast<float>(std::sqrt(sample.cost.hits / hits / 2));
    std::vector<Rgb> answers(best.size());
    for (std::size_t i = 0; i < best.size(); ++i)
        answers[i] = best[i] + shown_bias[i] + (sample.halves.a[i] - sample.halves.b[i]) * noise;
    return common::flip_mean(common::flip_map(picture_of(answers), reference_,
                                              static_cast<int>(points_.width),
                                              static_cast<int>(points_.height), exposures_));
}

std::vector<NeededHits> needed_by_flip(const SelfEstimates& estimates, std::span<const PilotSample> samples,
                                       const FitPoints& points, const FitGoal& goal) {
    const FlipForecast forecast(points, estimates);
    std::vector<NeededHits> needed(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
        if (samples[i].present() && estimates.model[i])
            needed[i] = needed_of(forecast, samples[i], *estimates.model[i], goal);
    });
    return needed;
}

}  // namespace bench::fit
