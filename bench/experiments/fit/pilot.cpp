#include "bench/experiments/fit/pilot.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/contenders/memory_need.h"
#include "bench/experiments/fit/traced_run.h"
#include "common/core/stopwatch.h"

namespace bench::fit {
namespace {

constexpr std::uint64_t first_photon_of_b = std::uint64_t{1} << 40;
constexpr double least_hits_per_texel = 2;  // with more texels an adaptive map has the same blocks, slower

/// Candidates that share one store, as indices into the list.
struct Group {
    std::vector<std::size_t> members;
    ContenderGroup contenders;
};

std::vector<Group> groups_of(std::span<const Candidate> candidates, std::span<const std::size_t> chosen,
                             std::uint64_t hits) {
    std::vector<Group> groups;
    for (const std::size_t i : chosen) {
        const Contender contender = candidates[i].contender(hits);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
            return share_store(g.contenders.front(), contender);
        });
        if (group == groups.end()) group = groups.insert(groups.end(), Group{});
        group->members.push_back(i);
        group->contenders.push_back(contender);
    }
    return groups;
}

/// Groups the stores into batches that fit into memory together and are filled by one trace. Stores that do
/// not fit alone are left out.
std::vector<std::vector<Group>> batches_of(std::vector<Group> groups, const PilotSubject& subject,
                                           std::uint64_t hits) {
    const ContenderSettings& settings = subject.prepared.settings();
    std::erase_if(groups, [&](const Group& group) {
        return !reason_to_skip(group.contenders.front(), settings, hits, subject.max_bytes).empty();
    });
    return in_batches(std::move(groups), subject.max_bytes, [&](const Group& group) {
        return needed_bytes(group.contenders.front(), settings, hits);
    });
}

/// Adds half of the cost of this half, so that two halves add up to their mean.
void add_cost(PilotCost& cost, const common::TraceReport& trace, const FilledStore& filled,
              const FinishedMap& map, double gather_seconds) {
    cost.hits += 0.5 * static_cast<double>(trace.hits);
    cost.trace_seconds += 0.5 * trace.trace_seconds;
    cost.insert_seconds += 0.5 * filled.insert_seconds;
    cost.build_seconds += 0.5 * (filled.making_room_seconds + map.build_seconds);
    cost.gather_seconds += 0.5 * gather_seconds;
    cost.bytes += 0.5 * static_cast<double>(map.answers->bytes());
    cost.prepare_seconds = filled.preparation.seconds;
}

void fill_half(const PilotSubject& subject, const std::vector<Group>& batch, std::uint64_t hits,
               bool second_half, const StopRule& stop, std::vector<PilotSample>& samples) {
    std::vector<FilledStore> stores;
    for (const Group& group : batch) {
        stop.check();  // millions of texels take seconds to lay out
        stores.emplace_back(group.contenders, subject.prepared, subject.source);
    }
    const common::TraceReport trace =
        traced_run(fmt::format("{} pilot {:g}", subject.loaded.name, static_cast<double>(hits)),
                   subject.loaded, subject.source, subject.seed,
                   {.hits = hits, .first_photon = second_half ? first_photon_of_b : 0}, stores, stop);
    for (std::size_t g = 0; g < batch.size(); ++g) {
        for (std::size_t i = 0; i < batch[g].members.size(); ++i) {
            stop.check();
            PilotSample& sample = samples[batch[g].members[i]];
            if (!second_half) sample = {};
            const FinishedMap map = batch[g].contenders[i]->finish(*stores[g].store, trace);
            const common::Stopwatch gather;
            (second_half ? sample.halves.b : sample.halves.a) = ask(*map.answers, subject.points.point);
            add_cost(sample.cost, trace, stores[g], map, gather.seconds());
        }
        stores[g].store.reset();
    }
}

}  // namespace

bool is_measurable(const Candidate& candidate, std::uint64_t hits) {
    const double n = static_cast<double>(hits);
    switch (candidate.kind) {
        case CandidateKind::light_map:
            return candidate.value * least_hits_per_texel <= n;
        case CandidateKind::adaptive_map:
            return candidate.texels * least_hits_per_texel <= n;
        case CandidateKind::photon_share:
            return candidate.value * n >= least_nearest && candidate.value * n <= most_nearest;
        case CandidateKind::photon_radius:
            break;
    }
    return true;
}

void run_pilot(const PilotSubject& subject, std::span<const Candidate> candidates,
               std::span<const std::size_t> chosen, std::uint64_t hits, const StopRule& stop,
               std::vector<PilotSample>& samples) {
    for (const std::vector<Group>& batch : batches_of(groups_of(candidates, chosen, hits), subject, hits))
        for (const bool second_half : {false, true})
            fill_half(subject, batch, hits, second_half, stop, samples);
}

}  // namespace bench::fit
