#include "bench/experiments/fit/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/contenders/memory_need.h"

namespace bench::fit {
namespace {

std::string percent(double error_sq) {
    return fmt::format("{:.3g} %", 100 * std::sqrt(error_sq));
}

const char* kind_name(bool light_maps) {
    return light_maps ? "light map" : "photon map";
}

std::string target_text(const FitGoal& goal) {
    return fmt::format("{:g} %", 100 * goal.target);
}

/// Returns the sort key: the cost that the goal names, then a tie-breaker. Bytes are followed by hits, not by
/// seconds: seconds are measured, and choices by bytes must be repeatable.
std::pair<double, double> price(const Proposal& proposal, const FitGoal& goal) {
    const auto& [seconds, bytes, once] = proposal.cost;
    return goal.least_bytes ? std::pair(bytes, proposal.hits) : std::pair(seconds, bytes);
}

Proposal proposal_at(const Knowledge& known, std::size_t i, double hits) {
    return {i, hits, known.needed[i].expected, *known.estimates.model[i],
            cost_at(known.candidates[i], *known.costs[i], hits)};
}

bool is_known(const Knowledge& known, std::size_t i, bool light_maps) {
    return known.candidates[i].is_light_map() == light_maps && known.estimates.model[i] && known.costs[i];
}

/// Returns the most hits with which the candidate can be used.
double most_hits(const Candidate& candidate) {
    return candidate.kind == CandidateKind::photon_share ? most_nearest / candidate.value
                                                         : std::numeric_limits<double>::infinity();
}

/// Says which limit of the goal the proposal exceeds; empty if none.
std::string beyond(const Knowledge& known, const FitGoal& goal, const Proposal& proposal) {
    if (proposal.hits > goal.max_hits)
        return fmt::format("{:.3g} hits, and --max-hits is {:.3g}", proposal.hits, goal.max_hits);
    if (proposal.cost.bytes > goal.budget_bytes)
        return fmt::format("{:.4g} bytes, and --budget-bytes is {:.4g}", proposal.cost.bytes,
                           goal.budget_bytes);
    if (proposal.cost.seconds > goal.budget_seconds)
        return fmt::format("{:.3g} s, and --budget-time is {:.3g} s", proposal.cost.seconds,
                           goal.budget_seconds);
    const auto hits = static_cast<std::uint64_t>(proposal.hits);
    const Contender method = known.candidates[proposal.candidate].contender(hits);
    const std::string memory = reason_to_skip(method, known.settings, hits, known.max_bytes);
    return memory.empty() ? "" : fmt::format("memory: {} with {:.3g} hits", memory, proposal.hits);
}

/// Explains why even the candidate with the least bias does not reach the target.
std::string bias_forbids(const Proposal& least, const std::string& name, const FitGoal& goal,
                         bool light_maps) {
    const ErrorModel& model = least.model;
    if (model.lower_bias_sq(goal.z) > goal.target * goal.target)
        return fmt::format(
            "{:g} % is below the bias of {}, {} (blur {}, truncation {}), the least of all {}s: "
            "no setting of the grid reaches it",
            100 * goal.target, name, percent(model.bias_sq()), percent(model.blur_sq),
            percent(model.truncation_sq), kind_name(light_maps));
    return fmt::format(
        "{:g} % may be below the bias of {}, the least of all {}s: it is {}, and {} at most as "
        "far as the pilot can tell; a larger --pilot knows more",
        100 * goal.target, name, kind_name(light_maps), percent(model.bias_sq()),
        percent(model.upper_bias_sq(goal.z)));
}

/// Returns the candidate with the least bias, at the most hits that are allowed. It skips adaptive maps,
/// whose bias falls with more hits.
Choice out_of_reach(const Knowledge& known, const FitGoal& goal, bool light_maps) {
    Choice choice;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < known.candidates.size(); ++i) {
        if (!is_known(known, i, light_maps) || known.candidates[i].is_adaptive()) continue;
        if (known.needed[i].without_noise >= least) continue;
        least = known.needed[i].without_noise;
        choice.proposal = proposal_at(known, i, std::min(goal.max_hits, most_hits(known.candidates[i])));
    }
    if (!std::isfinite(least)) {
        choice.reason = fmt::format("no {} of the grid could be measured", kind_name(light_maps));
        return choice;
    }
    const std::string name =
        known.candidates[choice.proposal.candidate].name(static_cast<std::uint64_t>(choice.proposal.hits));
    choice.reason = bias_forbids(choice.proposal, name, goal, light_maps);
    return choice;
}

}  // namespace

std::vector<Proposal> proposals(const Knowledge& known, const FitGoal& goal, bool light_maps) {
    std::vector<Proposal> all;
    for (std::size_t i = 0; i < known.candidates.size(); ++i) {
        if (!is_known(known, i, light_maps)) continue;
        std::optional<double> hits = known.needed[i].sure;
        if (!hits) continue;
        if (known.candidates[i].kind == CandidateKind::photon_share)
            hits = std::max(*hits, least_nearest / known.candidates[i].value);
        if (*hits <= most_hits(known.candidates[i])) all.push_back(proposal_at(known, i, std::ceil(*hits)));
    }
    std::stable_sort(all.begin(), all.end(),
                     [&](const Proposal& a, const Proposal& b) { return price(a, goal) < price(b, goal); });
    return all;
}

Choice choose(const Knowledge& known, const FitGoal& goal, bool light_maps) {
    const std::vector<Proposal> all = proposals(known, goal, light_maps);
    if (all.empty()) return out_of_reach(known, goal, light_maps);
    for (const Proposal& proposal : all)
        if (beyond(known, goal, proposal).empty()) return {true, "", proposal};
    const Proposal& cheapest = all.front();
    return {false,
            fmt::format("every {} that reaches {} is beyond what may be spent: {} takes {}",
                        kind_name(light_maps), target_text(goal),
                        known.candidates[cheapest.candidate].name(static_cast<std::uint64_t>(cheapest.hits)),
                        beyond(known, goal, cheapest)),
            cheapest};
}

std::string doubts(const Knowledge& known, const FitGoal& goal, const Choice& choice,
                   const std::string& lost_light) {
    if (!choice.reached) return "";
    if (!lost_light.empty())
        return fmt::format("{}: no path finds it, so that errors are counted from the finest photon map",
                           lost_light);
    const ErrorModel& model = choice.proposal.model;
    if (z_of(goal, model) * model.doubt(choice.proposal.hits) > most_doubt * goal.target * goal.target)
        return "chance has a large part in the estimate; a larger --pilot knows more";
    if (!known.estimates.measured[choice.proposal.candidate])
        return "its bias is carried on from coarser maps; a larger --pilot measures it";
    return "";
}

}  // namespace bench::fit
