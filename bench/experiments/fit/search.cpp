#include "bench/experiments/fit/search.h"

#include <algorithm>
#include <cmath>

#include "bench/setup/ending.h"
#include "common/core/input_error.h"

namespace bench::fit {
namespace {

constexpr std::uint64_t growth = 4;
constexpr int most_growths = 6;          // from the first pilot to the largest
constexpr double enough = 1.1;           // a candidate is settled if its hits are known to a tenth
constexpr double worth_it = 1.2;         // go on if certainty might make the choice cheaper by so much
constexpr std::size_t most_rivals = 24;  // of one kind, in pilots after the first

struct State {
    PilotArchive& archive;
    const FitGoal& goal;
    FitResult result;
    int truth_level = 0;

    State(PilotArchive& a, const FitGoal& g) : archive(a), goal(g) {
        result.candidates = archive.candidates();
        result.samples.resize(result.candidates.size());
        result.lost_light = archive.truth().lost_light();
    }
};

Knowledge knowledge_of(const State& state) {
    const FitResult& result = state.result;
    const PilotSubject& subject = state.archive.subject();
    return {result.candidates,           result.estimates, result.needed, result.costs,
            subject.prepared.settings(), subject.max_bytes};
}

double price_of(const FitGoal& goal, const FitCost& cost) {
    return goal.least_bytes ? cost.bytes : cost.seconds;
}

/// Returns the cost of the candidate with so many hits; infinite where no number of hits is allowed.
double price_with(const State& state, std::size_t i, const std::optional<double>& hits) {
    if (!hits || *hits > state.goal.max_hits) return std::numeric_limits<double>::infinity();
    return price_of(state.goal, cost_at(state.result.candidates[i], *state.result.costs[i], *hits));
}

/// Returns the cost of the candidate in the best case; infinite if it cannot reach the target.
double least_price(const State& state, std::size_t i) {
    return price_with(state, i, state.result.needed[i].least);
}

/// Returns the cost of the candidate if the estimates were exact.
double likely_price(const State& state, std::size_t i) {
    return price_with(state, i, state.result.needed[i].likely);
}

/// Returns the cost of the choice; infinite if nothing was reached.
double price_of(const State& state, const Decision& decision) {
    return decision.choice.reached ? price_of(state.goal, decision.choice.proposal.cost)
                                   : std::numeric_limits<double>::infinity();
}

/// Returns whether certainty would hardly change the hits of the candidate.
bool is_settled(const State& state, std::size_t i) {
    const NeededHits& needed = state.result.needed[i];
    return state.result.estimates.measured[i] && needed.sure && needed.likely &&
           *needed.sure < enough * *needed.likely;
}

/// Returns whether a map with this limit on its own error may be the cheapest that reaches the target.
bool is_near_target(const Candidate& candidate, const FitGoal& goal) {
    if (!candidate.is_adaptive()) return true;
    constexpr double least = 0.2, most = 1.2;  // with few hits the error is larger than the limit
    const double wanted = candidate.value / 100 / goal.target;
    return wanted >= least && wanted <= most;
}

std::vector<std::size_t> all_measurable(const State& state, std::uint64_t hits) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < state.result.candidates.size(); ++i)
        if (is_measurable(state.result.candidates[i], hits) &&
            is_near_target(state.result.candidates[i], state.goal))
            chosen.push_back(i);
    return chosen;
}

/// Returns whether an adaptive map with so many hits takes longer to trace than the choice takes in all. If
/// so, measuring it cannot save time.
bool is_beaten(const State& state, const Candidate& candidate, std::uint64_t hits) {
    const Choice& choice = state.result.light_map.choice;
    if (!candidate.is_adaptive() || !choice.reached || state.goal.least_bytes) return false;
    const PilotCost& cost = *state.result.costs[choice.proposal.candidate];
    return cost.trace_seconds * static_cast<double>(hits) / cost.hits > choice.proposal.cost.seconds;
}

/// Returns the cheapest of these candidates: half of them in the best case, half if the estimates were exact.
/// The best case alone prefers those of which little is known, however unlikely it is that they do.
std::vector<std::size_t> cheapest(const State& state, std::vector<std::size_t> rivals) {
    if (rivals.size() <= most_rivals) return rivals;
    const auto middle = rivals.begin() + most_rivals / 2, end = rivals.begin() + most_rivals;
    std::ranges::partial_sort(rivals, middle, {}, [&](std::size_t i) { return least_price(state, i); });
    std::ranges::partial_sort(middle, end, rivals.end(), {},
                              [&](std::size_t i) { return likely_price(state, i); });
    rivals.erase(end, rivals.end());
    return rivals;
}

/// Returns the candidates of one kind that are worth tracing. These are all whose model or cost is unknown,
/// and the cheapest of those that may be as cheap as the choice and are not settled.
std::vector<std::size_t> rivals(const State& state, std::uint64_t hits, bool light_maps) {
    const FitResult& result = state.result;
    const double price = price_of(state, light_maps ? result.light_map : result.photon_map);
    std::vector<std::size_t> chosen;
    std::vector<std::size_t> known;
    for (const std::size_t i : all_measurable(state, hits)) {
        if (result.candidates[i].is_light_map() != light_maps || is_beaten(state, result.candidates[i], hits))
            continue;
        if (!result.estimates.model[i] || !result.costs[i]) {
            chosen.push_back(i);
            continue;
        }
        const double least = least_price(state, i);
        if (std::isfinite(least) && least <= price && !is_settled(state, i)) known.push_back(i);
    }
    for (const std::size_t i : cheapest(state, std::move(known))) chosen.push_back(i);
    return chosen;
}

std::vector<std::size_t> to_trace(const State& state, std::uint64_t hits) {
    if (state.result.estimates.model.empty()) return all_measurable(state, hits);
    std::vector<std::size_t> chosen = rivals(state, hits, true);
    for (const std::size_t i : rivals(state, hits, false)) chosen.push_back(i);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

/// Returns whether more knowledge could save little or nothing.
bool is_decided(const State& state, const Decision& decision, bool light_maps) {
    for (std::size_t i = 0; i < state.result.candidates.size(); ++i) {
        if (state.result.candidates[i].is_light_map() != light_maps || !state.result.estimates.model[i])
            continue;
        const double least = least_price(state, i);
        if (std::isfinite(least) && least * worth_it < price_of(state, decision)) return false;
    }
    return true;
}

bool is_open(const State& state) {
    const auto open = [&](const Decision& decision, bool light_maps) {
        return !decision.doubt.empty() || !is_decided(state, decision, light_maps);
    };
    return open(state.result.light_map, true) || open(state.result.photon_map, false);
}

bool is_sure(const State& state) {
    return state.result.light_map.doubt.empty() && state.result.photon_map.doubt.empty();
}

/// Returns whether the next pilot is too expensive: large beside the chosen runs, and longer than about a
/// second. Less is spent when the choices are sure and only may not be the cheapest.
bool is_too_dear(const State& state, std::uint64_t next_hits) {
    const auto hits_of = [&](const Decision& decision) {
        return decision.choice.reached ? decision.choice.proposal.hits : state.goal.max_hits;
    };
    constexpr double worth = 0.05, cheap = 4e6, cheap_if_sure = 1e6;
    const double hits = 2 * static_cast<double>(next_hits);
    const double runs = hits_of(state.result.light_map) + hits_of(state.result.photon_map);
    return hits > worth * runs && hits > (is_sure(state) ? cheap_if_sure : cheap);
}

Decision decided(const State& state, bool light_maps) {
    const Knowledge known = knowledge_of(state);
    Decision decision{choose(known, state.goal, light_maps), "", {}};
    decision.doubt = doubts(known, state.goal, decision.choice, state.result.lost_light);
    return decision;
}

/// Chooses again from all samples. Returns false if the pilot was too small for that.
bool choose_both(State& state, const StopRule& stop) {
    static const Halves none;
    FitResult& result = state.result;
    const Halves& truth =
        result.lost_light.empty() ? state.archive.truth().at(state.truth_level, stop) : none;
    auto estimates = estimate_errors(result.candidates, result.samples, truth, state.archive.subject().points,
                                     std::move(result.estimates.best_answers), state.goal.z);
    if (!estimates) return false;
    result.estimates = std::move(*estimates);
    result.truth_samples = truth.present() ? PathTruth::samples_of(state.truth_level) : 0;
    result.needed = needed_by_error(result.estimates, state.goal);
    result.costs = costs_of(result.candidates, result.samples);
    result.light_map = decided(state, true);
    result.photon_map = decided(state, false);
    return true;
}

/// Returns whether the noise of the paths uses up half of the doubt that is allowed.
bool truth_is_noisy(const State& state) {
    return state.result.truth_samples > 0 && state.goal.z * state.result.estimates.truth_doubt >
                                                 most_doubt / 2 * state.goal.target * state.goal.target;
}

/// Chooses, and adds paths where their noise matters: at most one level for each pilot. Returns false if the
/// pilot was too small to choose from.
bool choose_by_paths(State& state, int most_level, const StopRule& stop) {
    if (!choose_both(state, stop)) return false;
    while (state.truth_level < most_level && truth_is_noisy(state) && is_open(state)) {
        ++state.truth_level;
        (void)choose_both(state, stop);
    }
    return true;
}

/// Tries the chosen adaptive map with fewer and fewer hits, as long as that is cheaper. Its blocks change
/// with the hits, so that only a run tells whether so many suffice, and the sizes of the pilots are far
/// apart.
void look_for_fewer_hits(State& state, const StopRule& stop) {
    constexpr double share = 0.8;
    const Choice& choice = state.result.light_map.choice;
    while (choice.reached && state.result.candidates[choice.proposal.candidate].is_adaptive()) {
        const std::size_t chosen = choice.proposal.candidate;
        const double price = price_of(state, state.result.light_map);
        const auto fewer = static_cast<std::uint64_t>(share * choice.proposal.hits);
        const PilotSample known = state.result.samples[chosen];
        state.archive.run_pilot(std::span(&chosen, 1), fewer, stop, state.result.samples);
        (void)choose_both(state, stop);
        if (price_of(state, state.result.light_map) < price) continue;
        state.result.samples[chosen] = known;
        (void)choose_both(state, stop);
        return;
    }
}

/// Returns the hits of each half of the first pilot, from which fourfold growth ends at the largest.
std::uint64_t first_pilot_hits(std::uint64_t largest) {
    std::uint64_t hits = largest;
    for (int i = 0; i < most_growths && hits / growth >= fewest_pilot_hits; ++i) hits /= growth;
    return hits;
}

/// Runs the pilots after the first one, which has `hits` per half.
void grow_pilot(State& state, std::uint64_t hits, const SearchLimits& limits, const StopRule& stop) {
    bool known = !state.result.estimates.model.empty();
    for (int level = 1; !known || is_open(state); ++level) {
        hits *= growth;
        if (hits > limits.pilot_hits || (known && is_too_dear(state, hits))) break;
        state.archive.run_pilot(to_trace(state, hits), hits, stop, state.result.samples);
        state.result.pilot_hits = hits;
        known = choose_by_paths(state, level, stop);
    }
    if (known && !state.goal.least_bytes) look_for_fewer_hits(state, stop);
}

}  // namespace

FitResult search(PilotArchive& archive, const FitGoal& goal, const SearchLimits& limits) {
    State state(archive, goal);
    const common::Stopwatch watch;
    const StopRule by_time(limits.seconds), by_user;
    const std::uint64_t first = first_pilot_hits(limits.pilot_hits);
    try {
        archive.run_pilot(to_trace(state, first), first, by_user, state.result.samples);
        state.result.pilot_hits = first;
        (void)choose_both(state, by_user);
        grow_pilot(state, first, limits, by_time);
    } catch (const Stopped& reason) {
        state.result.stopped = reason.what();
    }
    if (state.result.estimates.model.empty()) {
        if (!state.result.stopped.empty())
            throw Interrupted("fit stopped: what is not finished is not written");
        throw common::InputError("--pilot: too few hits to measure any map; take more, or free memory");
    }
    state.result.light_map.proposals = proposals(knowledge_of(state), goal, true);
    state.result.photon_map.proposals = proposals(knowledge_of(state), goal, false);
    state.result.pilot_seconds = watch.seconds();
    return std::move(state.result);
}

}  // namespace bench::fit
