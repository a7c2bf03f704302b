#include "bench/experiments/fit/cost_model.h"

#include <algorithm>

namespace bench::fit {

FitCost cost_at(const Candidate& candidate, const PilotCost& pilot, double hits) {
    const double times = hits / pilot.hits, grows = candidate.is_light_map() ? 1 : times;
    return {.seconds = times * (pilot.trace_seconds + pilot.insert_seconds) +
                       grows * (pilot.build_seconds + pilot.gather_seconds),
            .bytes = grows * pilot.bytes,
            .prepare_seconds = pilot.prepare_seconds};
}

namespace {

/// Returns the seconds per hit of the largest pilot.
double trace_seconds_per_hit(std::span<const PilotSample> samples) {
    const PilotSample& largest =
        *std::ranges::max_element(samples, {}, [](const PilotSample& sample) { return sample.cost.hits; });
    return largest.present() ? largest.cost.trace_seconds / largest.cost.hits : 0;
}

}  // namespace

std::vector<std::optional<PilotCost>> costs_of(std::span<const Candidate> candidates,
                                               std::span<const PilotSample> samples) {
    std::vector<std::optional<PilotCost>> costs(candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (samples[i].present()) {
            costs[i] = samples[i].cost;
        } else if (i > 0 && costs[i - 1] && candidates[i].chain() == candidates[i - 1].chain()) {
            costs[i] = costs[i - 1];
            if (!candidates[i].is_light_map()) continue;
            const double more = candidates[i].value / candidates[i - 1].value;
            costs[i]->bytes *= more;
            costs[i]->build_seconds *= more;
            costs[i]->prepare_seconds *= more;
        }
    }
    const double trace_seconds = trace_seconds_per_hit(samples);
    for (std::optional<PilotCost>& cost : costs)
        if (cost) cost->trace_seconds = trace_seconds * cost->hits;
    return costs;
}

}  // namespace bench::fit
