#include "bench/experiments/fit/search.h"

#include <algorithm>
#include <cmath>

#include "common/core/input_error.h"

namespace bench::fit {
namespace {

constexpr std::uint64_t growth = 4;
constexpr int most_growths = 5;   // from the first pilot to the largest
constexpr double enough = 1.1;    // a candidate's hits are known to a tenth
constexpr double worth_it = 1.2;  // the choice might cost so much less if there were no doubt

struct State {
    const PilotSubject& subject;
    const FitGoal& goal;
    std::vector<Candidate> candidates = all_candidates();
    std::vector<PilotSample> samples = std::vector<PilotSample>(candidates.size());
    FitResult result = {};
};

Knowledge knowledge_of(const State& state) {
    return {state.candidates,
            state.result.estimates,
            state.result.needed,
            state.result.costs,
            state.subject.prepared.settings(),
            state.subject.max_bytes};
}

double price_of(const FitGoal& goal, const FitCost& cost) {
    return goal.least_bytes ? cost.bytes : cost.seconds;
}

/// What the candidate would cost at the very best; infinite where that is out of reach.
double least_price(const State& state, std::size_t i) {
    const std::optional<double> hits = state.result.needed[i].least;
    if (!hits || *hits > state.goal.max_hits) return std::numeric_limits<double>::infinity();
    return price_of(state.goal, cost_at(state.candidates[i], *state.result.costs[i], *hits));
}

/// Whether its hits would hardly change if there were no doubt about them.
bool is_settled(const State& state, std::size_t i) {
    const NeededHits& needed = state.result.needed[i];
    return needed.sure && needed.likely && *needed.sure < enough * *needed.likely;
}

/// The finest maps that there are, by which all others are measured.
bool is_measure(const State& state, std::size_t i) {
    const Candidate& candidate = state.candidates[i];
    const Candidate& finest = state.candidates[state.result.estimates.finest.candidate];
    return candidate.kind == CandidateKind::light_map && candidate.basis == finest_basis() &&
           candidate.value >= finest.value / 4;
}

bool is_worth_tracing(const State& state, std::size_t i) {
    if (is_measure(state, i)) return true;
    if (!state.result.estimates.model[i] || !state.result.costs[i]) return true;
    const Choice& choice =
        state.candidates[i].is_light_map() ? state.result.light_map : state.result.photon_map;
    const double best =
        choice.reached ? price_of(state.goal, choice.proposal.cost) : std::numeric_limits<double>::infinity();
    const double least = least_price(state, i);
    return std::isfinite(least) && least <= best && !is_settled(state, i);
}

/// Whether a map that wants so much error of itself may be the cheapest that reaches the target.
bool is_near_target(const Candidate& candidate, const FitGoal& goal) {
    if (!candidate.is_adaptive()) return true;
    constexpr double least = 0.2, most = 1.5;  // few hits bring more error than was wanted
    const double wanted = candidate.value / 100 / goal.target;
    return wanted >= least && wanted <= most;
}

std::vector<std::size_t> to_trace(const State& state, std::uint64_t hits, bool first) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < state.candidates.size(); ++i)
        if (is_measurable(state.candidates[i], hits) && is_near_target(state.candidates[i], state.goal) &&
            (first || is_worth_tracing(state, i)))
            chosen.push_back(i);
    return chosen;
}

/// Whether knowing more could save little, or nothing can be saved.
bool is_decided(const State& state, const Choice& choice, bool light_maps) {
    for (std::size_t i = 0; i < state.candidates.size(); ++i) {
        if (state.candidates[i].is_light_map() != light_maps || !state.result.estimates.model[i]) continue;
        const double least = least_price(state, i);
        if (!std::isfinite(least)) continue;
        if (!choice.reached || least * worth_it < price_of(state.goal, choice.proposal.cost)) return false;
    }
    return true;
}

/// Whether what all maps are measured by blurs little itself. The rest is extrapolated, and creases narrower
/// than its texels are in no extrapolation: on the atrium a few points in such creases have half the error.
bool is_well_measured(const State& state) {
    if (!state.result.light_map.reached && !state.result.photon_map.reached) return true;
    const double blur_sq = std::max(0.0, state.result.estimates.finest.blur_sq.value);
    return blur_sq <= most_doubt * state.goal.target * state.goal.target;
}

/// Whether the next pilot would be larger than many of the runs it is about: those with the most hits that
/// are allowed, where the target is out of reach so far.
bool is_dearer_than_runs(const State& state, std::uint64_t next_hits) {
    const auto hits_of = [&](const Choice& choice) {
        return choice.reached ? choice.proposal.hits : state.goal.max_hits;
    };
    constexpr double worth = 16;  // what is found serves many runs
    return 2 * static_cast<double>(next_hits) >
           worth * (hits_of(state.result.light_map) + hits_of(state.result.photon_map));
}

/// Chooses anew from all samples. False where the pilot was too small for that.
bool choose_both(State& state) {
    auto estimates = estimate_errors(state.candidates, state.samples, state.subject.points, state.goal.target,
                                     state.goal.z);
    if (!estimates) return false;
    state.result.estimates = std::move(*estimates);
    state.result.needed = needed_by_error(state.result.estimates, state.goal);
    state.result.costs = costs_of(state.candidates, state.samples);
    state.result.light_map = choose(knowledge_of(state), state.goal, true);
    state.result.photon_map = choose(knowledge_of(state), state.goal, false);
    return true;
}

/// Those whose blocks change with their hits, and that reach the target with the hits of their sample.
std::vector<std::size_t> to_trace_with_fewer(const State& state, std::uint64_t hits) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < state.candidates.size(); ++i)
        if (state.candidates[i].changes_with_hits() && state.result.needed[i].sure &&
            is_measurable(state.candidates[i], hits))
            chosen.push_back(i);
    return chosen;
}

/// Where blocks change with the hits, nothing says how many suffice but a run with so many, and those of the
/// pilots are far apart. Tries fewer than the light map that was chosen has, and fewer again, as long as one
/// of them is cheaper. All are measured by the finest maps of the largest pilot.
void look_for_fewer_hits(State& state) {
    constexpr double share = 0.8;
    const Choice& choice = state.result.light_map;
    for (double hits = share * choice.proposal.hits; choice.reached; hits *= share) {
        const double price = price_of(state.goal, choice.proposal.cost);
        const auto fewer = static_cast<std::uint64_t>(hits);
        const std::vector<std::size_t> tried = to_trace_with_fewer(state, fewer);
        const std::vector<PilotSample> known = state.samples;
        run_pilot(state.subject, state.candidates, tried, fewer, state.samples);
        (void)choose_both(state);
        const bool cheaper = choice.reached && price_of(state.goal, choice.proposal.cost) < price;
        for (const std::size_t i : tried)
            if (!cheaper || !state.result.needed[i].sure) state.samples[i] = known[i];
        (void)choose_both(state);
        if (!cheaper) return;
    }
}

/// Of each half of the first of those pilots that grow to the largest.
std::uint64_t first_pilot_hits(std::uint64_t largest) {
    std::uint64_t hits = largest;
    for (int i = 0; i < most_growths && hits / growth >= fewest_pilot_hits; ++i) hits /= growth;
    return hits;
}

}  // namespace

FitResult search(const PilotSubject& subject, const FitGoal& goal, const SearchLimits& limits,
                 PilotArchive& archive) {
    State state{subject, goal};
    const common::Stopwatch watch;
    bool known = false;
    for (std::uint64_t hits = first_pilot_hits(limits.pilot_hits); hits <= limits.pilot_hits;
         hits *= growth) {
        archive.run_pilot(subject, to_trace(state, hits, !known), hits, state.samples);
        state.result.pilot_hits = hits;
        known = choose_both(state);
        if (!known || !is_well_measured(state) || !is_sure(goal, state.result.light_map) ||
            !is_sure(goal, state.result.photon_map))
            continue;
        if (is_dearer_than_runs(state, hits * growth) || (is_decided(state, state.result.light_map, true) &&
                                                          is_decided(state, state.result.photon_map, false)))
            break;
    }
    if (!known)
        throw common::InputError(
            "--pilot: too few hits to tell the blur of any light map; take more, or free memory");
    if (!goal.least_bytes) look_for_fewer_hits(state);
    state.result.light_maps = proposals(knowledge_of(state), goal, true);
    state.result.photon_maps = proposals(knowledge_of(state), goal, false);
    state.result.pilot_seconds = watch.seconds();
    state.result.candidates = std::move(state.candidates);
    state.result.samples = std::move(state.samples);
    return std::move(state.result);
}

}  // namespace bench::fit
