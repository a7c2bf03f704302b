#include "bench/experiments/fit/estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bench/experiments/fit/carry_on.h"

namespace bench::fit {
namespace {

using Candidates = std::span<const Candidate>;
using Samples = std::span<const PilotSample>;

/// Noise is what candidates are chosen by wrongly; of the finest map's blur the extrapolation takes some off.
constexpr double z_of_finest = 4;

/// Irradiance by normal of light with harmonics of equal strength in all bands has the power
/// (2 l + 1) A_l^2 in band l, A_l the cosine's coefficient (Ramamoorthi and Hanrahan 2001): what bands 6, 8,
/// ... have together is this share of band 4. Odd bands beyond 1 have none.
constexpr double bands_beyond_last = 0.32;

std::optional<std::size_t> find_measured(Candidates candidates, Samples samples, const Candidate& wanted) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        if (candidate.kind == wanted.kind && candidate.basis == wanted.basis &&
            candidate.gather == wanted.gather && candidate.value == wanted.value && samples[i].present())
            return i;
    }
    return std::nullopt;
}

Candidate with_basis(Candidate candidate, const std::string& basis) {
    candidate.basis = basis;
    return candidate;
}

Candidate with_texels_over(Candidate candidate, double divisor) {
    candidate.value /= divisor;
    return candidate;
}

/// fine - (coarse - fine) / 2, by halves.
Halves extrapolated(const Halves& fine, const Halves& coarse) {
    const auto extrapolate = [](const std::vector<common::Rgb>& f, const std::vector<common::Rgb>& c) {
        std::vector<common::Rgb> result(f.size());
        for (std::size_t i = 0; i < f.size(); ++i) result[i] = f[i] - 0.5f * (c[i] - f[i]);
        return result;
    };
    return {extrapolate(fine.a, coarse.a), extrapolate(fine.b, coarse.b)};
}

/// (F - E)^2 over (Q - F)^2 where blur falls as its width does, see Finest.
constexpr double usual_blur_share = 1.5;

/// The same whatever it does. As long as it takes three sizes of texels to tell how blur falls, no
/// more than five times as much is believed.
double blur_share(double coarse_sq, double fine_sq) {
    constexpr double most = 5;
    if (fine_sq <= 0) return usual_blur_share;
    const double falls_by = coarse_sq / fine_sq;
    return falls_by > 1 ? std::clamp(1 / (falls_by - 1), usual_blur_share, most) : most;
}

/// By this map. None without one of a quarter of its texels.
std::optional<Finest> finest_of(std::size_t fine, Candidates candidates, Samples samples,
                                const Measure& measure) {
    const auto quarter = find_measured(candidates, samples, with_texels_over(candidates[fine], 4));
    if (!quarter) return std::nullopt;
    const SquareEstimate difference_sq =
        squared_difference(samples[*quarter].halves, samples[fine].halves, measure);
    double coarse_sq = 2 * difference_sq.value;  // as if blur fell as its width does
    if (const auto sixteenth = find_measured(candidates, samples, with_texels_over(candidates[fine], 16)))
        coarse_sq = squared_difference(samples[*sixteenth].halves, samples[*quarter].halves, measure).value;
    Finest finest{.candidate = fine,
                  .truth = extrapolated(samples[fine].halves, samples[*quarter].halves),
                  .blur_sq = difference_sq.scaled(blur_share(coarse_sq, difference_sq.value)),
                  .unseen_sq = {},
                  .truncation_sq = {},
                  .expected_blur_sq = usual_blur_share * std::max(0.0, coarse_sq / 2)};
    finest.unseen_sq = finest.blur_sq;
    finest.unseen_sq += difference_sq.scaled(-0.25);
    if (const auto below =
            find_measured(candidates, samples, with_basis(candidates[fine], basis_below_finest())))
        finest.truncation_sq = squared_difference(samples[*below].halves, samples[fine].halves, measure)
                                   .scaled(bands_beyond_last);
    return finest;
}

/// Mean w (C - E)^2 of any map.
SquareEstimate bias_sq_by(const Finest& finest, const Halves& halves, const Measure& measure) {
    SquareEstimate bias_sq = squared_difference(halves, finest.truth, measure);
    bias_sq += finest.unseen_sq;
    bias_sq += finest.truncation_sq;
    return bias_sq;
}

/// Of all maps of the finest basis the one that measures best: with more texels there is less blur, and more
/// noise to hide that of the others. `probe`: whose bias is to be measured; its own blur where there is none.
std::optional<Finest> find_finest(Candidates candidates, Samples samples, const Measure& measure,
                                  std::optional<std::size_t> probe) {
    std::optional<Finest> finest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& fine = candidates[i];
        if (fine.kind != CandidateKind::light_map || fine.basis != finest_basis() || !samples[i].present())
            continue;
        std::optional<Finest> found = finest_of(i, candidates, samples, measure);
        if (!found) continue;
        const SquareEstimate doubt =
            probe ? bias_sq_by(*found, samples[*probe].halves, measure) : found->blur_sq;
        const double upper = found->expected_blur_sq + z_of_finest * doubt.standard_error();
        if (upper >= least) continue;
        least = upper;
        finest = std::move(found);
    }
    return finest;
}

double truncation_sq(std::size_t i, Candidates candidates, Samples samples, const Finest& finest,
                     const Measure& measure) {
    if (!candidates[i].is_light_map()) return 0;
    const auto whole = find_measured(candidates, samples, with_basis(candidates[i], finest_basis()));
    if (!whole) return 0;
    return std::max(0.0, squared_difference(samples[i].halves, samples[*whole].halves, measure).value) +
           std::max(0.0, finest.truncation_sq.value);
}

ErrorModel model_of(std::size_t i, Candidates candidates, Samples samples, const Finest& finest,
                    std::span<const common::Rgb> best, const Measure& measure) {
    const SquareEstimate bias_sq = bias_sq_by(finest, samples[i].halves, measure);
    const double known = std::max(0.0, bias_sq.value);
    const double truncation = std::min(known, truncation_sq(i, candidates, samples, finest, measure));
    return {.pilot_hits = samples[i].cost.hits,
            .noise_sq = noise_sq(samples[i].halves, measure),
            .blur_sq = known - truncation,
            .truncation_sq = truncation,
            .bias_variance = bias_sq.variance(),
            .spread_variance = variance_about(samples[i].halves, best, measure),
            .noise_variance = most_noise_variance(samples[i].halves, measure),
            .at_pilot_alone = candidates[i].changes_with_hits()};
}

std::optional<Estimates> estimate_by(Candidates candidates, Samples samples, const Measure& measure,
                                     std::span<const common::Rgb> best_answers,
                                     std::optional<std::size_t> probe) {
    const auto finest = find_finest(candidates, samples, measure, probe);
    if (!finest) return std::nullopt;
    Estimates estimates;
    estimates.finest = *finest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        estimates.measured.push_back(samples[i].present());
        estimates.model.emplace_back();
        if (!samples[i].present()) continue;
        const ErrorModel model = model_of(i, candidates, samples, *finest, best_answers, measure);
        estimates.model.back() = model;
        const double upper = model.bias_sq() + model.noise_sq / 2 + std::sqrt(model.bias_variance);
        if (upper >= least) continue;
        least = upper;
        estimates.best = i;
    }
    estimates.best_answers = mean_of(samples[estimates.best].halves);
    return estimates;
}

/// A photon map of about 64 nearest: nowhere far off, whatever the light is like.
std::optional<std::size_t> first_guess(Candidates candidates, Samples samples) {
    constexpr double usual = 64;
    std::optional<std::size_t> guess;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (candidates[i].kind != CandidateKind::photon_share || !samples[i].present()) continue;
        const double away = std::abs(std::log(candidates[i].value * samples[i].cost.hits / usual));
        if (away >= least) continue;
        least = away;
        guess = i;
    }
    return guess;
}

/// Of the candidates whose bias leaves room for noise where this error is wanted, but not for much, the one
/// with the least noise of its own. None where no error counts more than others.
std::optional<std::size_t> find_probe(std::span<const std::optional<ErrorModel>> model, double wanted_error) {
    if (wanted_error == 0) return std::nullopt;  // else any bias that chance has made 0 would do
    const double wanted_sq = wanted_error * wanted_error;
    std::optional<std::size_t> probe;
    for (std::size_t i = 0; i < model.size(); ++i) {
        if (!model[i] || model[i]->bias_sq() < wanted_sq / 4 || model[i]->bias_sq() > wanted_sq) continue;
        if (!probe || model[i]->spread_variance < model[*probe]->spread_variance) probe = i;
    }
    return probe;
}

}  // namespace

std::optional<Estimates> estimate_errors(Candidates candidates, Samples samples, const FitPoints& points,
                                         double wanted_error, double z) {
    const auto guess = first_guess(candidates, samples);
    if (!guess) return std::nullopt;
    std::vector<common::Rgb> best = mean_of(samples[*guess].halves);
    std::optional<Estimates> estimates;
    std::optional<std::size_t> probe;
    for (int pass = 0; pass < 2; ++pass) {
        estimates = estimate_by(candidates, samples, Measure(best, points.tile, points.tiling), best, probe);
        if (!estimates) return estimates;
        best = estimates->best_answers;
        probe = find_probe(estimates->model, wanted_error);
    }
    carry_on(candidates, z, estimates->model);
    return estimates;
}

}  // namespace bench::fit
