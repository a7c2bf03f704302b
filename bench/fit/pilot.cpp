#include "bench/fit/pilot.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/app/memory_need.h"
#include "bench/fit/traced_run.h"

namespace bench::fit {
namespace {

constexpr std::uint64_t first_photon_of_b = std::uint64_t{1} << 40;
constexpr double least_hits_per_texel = 4;
constexpr double most_texels_per_hit = 4;  // of an adaptive map: more make the same blocks of it, slowly

/// Candidates that one store serves, by their places in the list.
struct Group {
    std::vector<std::size_t> members;
    std::vector<Method> methods;
};

std::vector<Group> groups_of(std::span<const Candidate> candidates, std::span<const std::size_t> chosen,
                             std::uint64_t hits) {
    std::vector<Group> groups;
    for (const std::size_t i : chosen) {
        const Method method = parse_method("fit", candidates[i].name(hits));
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& g) { return fill_alike(g.methods.front(), method); });
        if (group == groups.end()) group = groups.insert(groups.end(), Group{});
        group->members.push_back(i);
        group->methods.push_back(method);
    }
    return groups;
}

/// Groups whose stores fit into memory side by side, filled by one trace. What does not fit alone is left
/// out.
std::vector<std::vector<Group>> batches_of(std::vector<Group> groups, const PilotSubject& subject,
                                           std::uint64_t hits) {
    std::vector<std::vector<Group>> batches;
    std::size_t free = 0;
    for (Group& group : groups) {
        const MethodSettings& settings = subject.prepared.settings();
        if (!reason_to_skip(group.methods.front(), settings, hits, subject.max_bytes).empty()) continue;
        const std::size_t needed = needed_bytes(group.methods.front(), settings, hits);
        if (batches.empty() || needed > free) {
            batches.emplace_back();
            free = subject.max_bytes;
        }
        free -= needed;
        batches.back().push_back(std::move(group));
    }
    return batches;
}

common::TraceReport trace_half(const PilotSubject& subject, std::uint64_t first_photon, std::uint64_t hits,
                               std::vector<StudyStore>& stores) {
    StudySink sink(stores);
    return traced_run(fmt::format("{} pilot {:g}", subject.loaded.name, static_cast<double>(hits)),
                      subject.loaded, subject.source, subject.seed,
                      {.hits = hits, .first_photon = first_photon}, sink);
}

/// Adds half of what this half has cost: the mean of two.
void add_cost(PilotCost& cost, const common::TraceReport& trace, const StudyMap& map, double insert_seconds,
              double gather_seconds) {
    cost.hits += 0.5 * static_cast<double>(trace.hits);
    cost.trace_seconds += 0.5 * trace.trace_seconds;
    cost.insert_seconds += 0.5 * insert_seconds;
    cost.build_seconds += 0.5 * map.build_seconds;
    cost.gather_seconds += 0.5 * gather_seconds;
    cost.bytes += 0.5 * static_cast<double>(map.bytes);
}

void fill_half(const PilotSubject& subject, const std::vector<Group>& batch, std::uint64_t hits,
               bool second_half, std::vector<PilotSample>& samples) {
    std::vector<StudyStore> stores;
    for (const Group& group : batch) {
        stop_if_interrupted();  // millions of texels take seconds to lay out
        stores.emplace_back(group.methods, subject.prepared, subject.source);
    }
    const common::TraceReport trace = trace_half(subject, second_half ? first_photon_of_b : 0, hits, stores);
    for (std::size_t g = 0; g < batch.size(); ++g) {
        std::size_t next = 0;
        const double insert_seconds = stores[g].insert_seconds();
        stores[g].finish(trace, [&](const StudyMap& map) {
            stop_if_interrupted();
            PilotSample& sample = samples[batch[g].members[next++]];
            const common::Stopwatch gather;
            (second_half ? sample.halves.b : sample.halves.a) = ask(map, subject.points.point);
            if (!second_half) sample.cost = {};
            add_cost(sample.cost, trace, map, insert_seconds, gather.seconds());
        });
        stores[g] = StudyStore();
    }
}

}  // namespace

bool is_measurable(const Candidate& candidate, std::uint64_t hits) {
    const double n = static_cast<double>(hits);
    switch (candidate.kind) {
        case CandidateKind::light_map:
            return candidate.value * least_hits_per_texel <= n;
        case CandidateKind::sharing_map:
            return candidate.value <= n;
        case CandidateKind::adaptive_map:
            return candidate.texels <= most_texels_per_hit * n;
        case CandidateKind::photon_share:
            return candidate.value * n >= least_nearest && candidate.value * n <= most_nearest;
        case CandidateKind::photon_radius:
            break;
    }
    return true;
}

void run_pilot(const PilotSubject& subject, std::span<const Candidate> candidates,
               std::span<const std::size_t> chosen, std::uint64_t hits, std::vector<PilotSample>& samples) {
    for (const std::vector<Group>& batch : batches_of(groups_of(candidates, chosen, hits), subject, hits))
        for (const bool second_half : {false, true}) fill_half(subject, batch, hits, second_half, samples);
}

}  // namespace bench::fit
