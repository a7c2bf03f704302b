#include "bench/experiments/fit/estimates.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/experiments/fit/carry_on.h"

namespace bench::fit {
namespace {

using Candidates = std::span<const Candidate>;
using Samples = std::span<const PilotSample>;

/// The power of bands 6, 8, ... of the irradiance over normals, relative to that of band 4. If radiance has
/// equal coefficients in all bands, irradiance has the power (2 l + 1) A_l^2 in band l, A_l being the
/// coefficient of the cosine (Ramamoorthi and Hanrahan 2001). Odd bands beyond 1 have none.
constexpr double bands_beyond_last = 1.0 / 3;

/// Returns the light map of the same texels and gather with another basis, or null if it was not measured.
const Halves* with_basis(const Candidate& candidate, const std::string& basis, Candidates candidates,
                         Samples samples) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (samples[i].present() && candidates[i].kind == CandidateKind::light_map &&
            candidates[i].basis == basis && candidates[i].gather == candidate.gather &&
            candidates[i].value == candidate.value)
            return &samples[i].halves;
    return nullptr;
}

/// Estimates the part of the squared bias that finer texels do not reduce: the difference from the finest
/// basis, plus the truncation of the finest basis itself.
double truncation_sq(std::size_t i, Candidates candidates, Samples samples, const Measure& measure) {
    if (candidates[i].kind != CandidateKind::light_map) return 0;
    const Halves* finest = with_basis(candidates[i], finest_basis(), candidates, samples);
    const Halves* below = with_basis(candidates[i], basis_below_finest(), candidates, samples);
    double sum = 0;
    if (finest) sum += std::max(0.0, squared_difference(samples[i].halves, *finest, measure).value);
    if (finest && below)
        sum += bands_beyond_last * std::max(0.0, squared_difference(*below, *finest, measure).value);
    return sum;
}

ErrorModel model_of(std::size_t i, Candidates candidates, Samples samples, const Halves& truth,
                    std::span<const common::Rgb> best, const Measure& measure) {
    const SquareEstimate bias_sq = squared_difference(samples[i].halves, truth, measure);
    const double known = std::max(0.0, bias_sq.value);
    const double truncation = std::min(known, truncation_sq(i, candidates, samples, measure));
    return {.pilot_hits = samples[i].cost.hits,
            .noise_sq = noise_sq(samples[i].halves, measure),
            .blur_sq = known - truncation,
            .truncation_sq = truncation,
            .bias_variance = bias_sq.variance(),
            .sampling_variance = bias_sq.sampling_variance,
            .spread_variance = variance_about(samples[i].halves, best, measure),
            .noise_variance = most_noise_variance(samples[i].halves, measure),
            .at_pilot_alone = candidates[i].is_adaptive()};
}

/// Returns the measured photon map of k nearest whose k is closest to this one.
const Halves* photons_near(double k, Candidates candidates, Samples samples) {
    const Halves* found = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (candidates[i].kind != CandidateKind::photon_share || !samples[i].present()) continue;
        const double away = std::abs(std::log(candidates[i].value * samples[i].cost.hits / k));
        if (away >= least) continue;
        least = away;
        found = &samples[i].halves;
    }
    return found;
}

std::size_t best_of(std::span<const std::optional<ErrorModel>> model) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < model.size(); ++i) {
        if (!model[i]) continue;
        const double upper =
            model[i]->bias_sq() + model[i]->noise_sq / 2 + std::sqrt(model[i]->bias_variance);
        if (upper >= least) continue;
        least = upper;
        best = i;
    }
    return best;
}

Estimates estimate_by(Candidates candidates, Samples samples, const Halves& truth, const Measure& measure,
                      std::span<const common::Rgb> best) {
    Estimates estimates;
    estimates.truth = truth;
    estimates.truth_doubt = std::sqrt(variance_about(truth, best, measure));
    estimates.model.resize(candidates.size());
    tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
        if (samples[i].present()) estimates.model[i] = model_of(i, candidates, samples, truth, best, measure);
    });
    for (const PilotSample& sample : samples) estimates.measured.push_back(sample.present());
    estimates.best = best_of(estimates.model);
    estimates.best_answers = joined(samples[estimates.best].halves, truth, measure);
    return estimates;
}

}  // namespace

std::optional<Estimates> estimate_errors(Candidates candidates, Samples samples, const Halves& truth,
                                         const FitPoints& points, std::vector<common::Rgb> best_so_far,
                                         double z) {
    constexpr double nowhere_far_off = 64;  // a k that gives a usable estimate in any light
    const Halves* guess = photons_near(nowhere_far_off, candidates, samples);
    if (!guess) return std::nullopt;
    const Halves& against = truth.present() ? truth : *photons_near(least_nearest, candidates, samples);
    const auto by = [&](std::span<const common::Rgb> best) {
        return estimate_by(candidates, samples, against, Measure(best, points.tile, points.tiling), best);
    };
    if (best_so_far.empty()) best_so_far = by(mean_of(*guess)).best_answers;
    Estimates estimates = by(best_so_far);
    carry_on(candidates, z, estimates.model);
    return estimates;
}

}  // namespace bench::fit
