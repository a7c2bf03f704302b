#include "bench/experiments/fit/needed_hits.h"

#include <algorithm>
#include <cmath>

namespace bench::fit {
namespace {

std::optional<double> least_hits(const ErrorModel& model, bool measured, const FitGoal& goal) {
    const double target_sq = goal.target * goal.target;
    if (model.at_pilot_alone)  // the best case: all of its error falls as noise does
        return model.pilot_hits * std::max(1.0, model.error_sq(model.pilot_hits) / target_sq);
    const double certain_bias_sq = measured ? std::max(0.0, model.lower_bias_sq(goal.z)) : 0.0;
    const double left = target_sq - certain_bias_sq;
    if (left <= 0) return std::nullopt;
    return model.noise_sq * model.pilot_hits / left;
}

}  // namespace

double z_of(const FitGoal& goal, const ErrorModel& model) {
    return model.at_pilot_alone ? goal.z_of_tries : goal.z;
}

std::vector<NeededHits> needed_by_error(const Estimates& estimates, const FitGoal& goal) {
    std::vector<NeededHits> needed(estimates.model.size());
    for (std::size_t i = 0; i < needed.size(); ++i) {
        if (!estimates.model[i]) continue;
        const ErrorModel& model = *estimates.model[i];
        needed[i] = {.sure = hits_for(model, goal.target, goal.margin * z_of(goal, model)),
                     .likely = hits_for(model, goal.target, 0),
                     .least = least_hits(model, estimates.measured[i], goal),
                     .without_noise = std::sqrt(std::max(0.0, model.upper_bias_sq(goal.z)))};
        if (needed[i].sure) needed[i].expected = std::sqrt(model.error_sq(*needed[i].sure));
    }
    return needed;
}

}  // namespace bench::fit
