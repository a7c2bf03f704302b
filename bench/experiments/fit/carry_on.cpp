#include "bench/experiments/fit/carry_on.h"

namespace bench::fit {
namespace {

/// Returns whether `width` is the true width of the blur. For the k nearest of a large share it is not: in
/// dark places the largest gather radius cuts them off, so that the blur falls more slowly.
bool has_width_of_its_own(const Candidate& candidate) {
    return candidate.kind != CandidateKind::photon_share;
}

/// Returns whether the extrapolated bias has the smaller upper bound and does not contradict the measured
/// one. If it contradicts, the law does not hold: maps too coarse to resolve anything lose hardly less when
/// they are a little finer.
bool says_more(const ErrorModel& carried, const ErrorModel& own, double z) {
    return carried.upper_bias_sq(z) < own.upper_bias_sq(z) &&
           carried.upper_bias_sq(z) >= own.lower_bias_sq(z);
}

/// Returns `own` with the bias of `carried`; the noise stays its own.
ErrorModel with_bias_of(ErrorModel own, const ErrorModel& carried) {
    own.blur_sq = carried.blur_sq;
    own.truncation_sq = carried.truncation_sq;
    own.bias_variance = carried.bias_variance;
    own.sampling_variance = carried.sampling_variance;
    return own;
}

}  // namespace

ErrorModel carried_on(const ErrorModel& coarse, double coarse_width, double width) {
    const double finer = coarse_width / width, finer_sq = finer * finer;
    ErrorModel model = coarse;
    model.noise_sq *= finer_sq;
    model.spread_variance *= finer_sq;
    model.noise_variance *= finer_sq;
    model.blur_sq /= finer;
    const double variance_falls_by = coarse.truncation_sq > 0 ? 1 : finer_sq;
    model.bias_variance /= variance_falls_by;
    model.sampling_variance /= variance_falls_by;
    return model;
}

void carry_on(std::span<const Candidate> candidates, double z, std::span<std::optional<ErrorModel>> model) {
    std::optional<std::size_t> known;  // the candidate whose bias is extrapolated
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (known && candidates[*known].chain() != candidates[i].chain()) known.reset();
        if (known) {
            const ErrorModel carried =
                carried_on(*model[*known], candidates[*known].width(), candidates[i].width());
            if (!model[i])
                model[i] = carried;
            else if (has_width_of_its_own(candidates[i]) && says_more(carried, *model[i], z))
                model[i] = with_bias_of(*model[i], carried);
        }
        if (model[i]) known = i;
    }
}

}  // namespace bench::fit
