#include "bench/study/study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/app/memory_need.h"
#include "bench/app/output_folder.h"
#include "bench/study/study_store.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

/// What all methods of a run share.
struct RunFacts {
    std::string scene;
    std::uint64_t hits_asked, seed;
    common::TraceReport trace;
};

Json row_start(const RunFacts& facts, const Method& method, const MethodSettings& settings) {
    const ShlmMethod* light_map = method.light_map();
    return {{"scene", facts.scene},
            {"method", method.name},
            {"texels", light_map ? PreparedMethods::texel_choice(*light_map, settings).count : 0},
            {"hits_asked", facts.hits_asked},
            {"seed", facts.seed}};
}

Json row_of(const RunFacts& facts, const StudyMap& map, const MethodSettings& settings,
            double insert_seconds) {
    Json row = row_start(facts, map.method, settings);
    row["hits"] = facts.trace.hits;
    row["photons_emitted"] = facts.trace.fates.emitted;
    row["trace_seconds"] = facts.trace.trace_seconds;
    row["insert_seconds"] = insert_seconds;
    row["build_seconds"] = map.build_seconds;
    row["bytes"] = map.bytes;
    row["insert_bytes"] = map.insert_bytes;
    row["hits_rejected"] = map.hits_rejected;
    if (map.method.light_map()) row["clamped_share"] = map.clamped_share;
    return row;
}

/// Folder of a method's answers, below the study's.
std::filesystem::path answers_folder(const std::string& scene, std::string method) {
    std::replace(method.begin(), method.end(), '/', '-');
    return std::filesystem::path("raw") / scene / method;
}

/// Why there are no texels to be had for the method; empty where there are.
std::string trouble_with_texels(const Method& method, PreparedMethods& prepared) {
    try {
        if (method.light_map()) (void)prepared.texels_of(*method.light_map());
        return "";
    } catch (const common::InputError& e) {
        return e.what();
    }
}

/// Groups that fit into memory side by side; rows with the reason for the others.
std::vector<MethodGroup> that_fit(std::vector<MethodGroup> groups, const StudyPlan& plan,
                                  PreparedMethods& prepared, const RunFacts& facts,
                                  std::vector<Json>& skipped) {
    std::size_t free = plan.max_bytes;
    std::erase_if(groups, [&](const MethodGroup& group) {
        std::string reason = reason_to_skip(group.front(), plan.settings, facts.hits_asked, free);
        if (reason.empty()) reason = trouble_with_texels(group.front(), prepared);
        for (const Method& method : group) {
            if (reason.empty()) continue;
            skipped.push_back(row_start(facts, method, plan.settings));
            skipped.back()["skipped"] = reason;
        }
        if (reason.empty()) free -= needed_bytes(group.front(), plan.settings, facts.hits_asked);
        return !reason.empty();
    });
    return groups;
}

}  // namespace

StudyRun run_study(const StudyPlan& plan, StudyScene& scene, const std::vector<Method>& methods,
                   std::uint64_t hits, std::uint64_t seed) {
    StudyRun run;
    RunFacts facts{scene.name(), hits, seed, {}};
    std::vector<StudyStore> stores;
    std::vector<MethodGroup> groups = that_fit(groups_of(methods), plan, scene.prepared(), facts, run.rows);
    // The first store finds a wave's hits in cache and its own sums not, so every seed begins with another.
    if (!groups.empty()) std::rotate(groups.begin(), groups.begin() + seed % groups.size(), groups.end());
    for (MethodGroup& group : groups) stores.emplace_back(std::move(group), scene.prepared(), scene.source());
    if (stores.empty()) return run;

    StudySink sink(stores);
    common::Progress progress(fmt::format("{} {:g} seed {}", scene.name(), static_cast<double>(hits), seed),
                              "hits", hits);
    facts.trace = common::trace_photons(scene.loaded().rays, scene.source(), seed, {.hits = hits}, sink,
                                        [&](const common::TraceReport& so_far) {
                                            progress.show(so_far.hits);
                                            return !common::interrupted();
                                        });
    for (StudyStore& store : stores) {
        if (common::interrupted()) return {{}, true};
        const double insert_seconds = store.insert_seconds();
        store.finish(facts.trace, [&](const StudyMap& map) {
            if (common::interrupted()) return;
            Json row = row_of(facts, map, plan.settings, insert_seconds);
            const common::Stopwatch gather;
            const std::vector<common::Rgb> answers = ask(map, scene.points());
            row["gather_seconds"] = gather.seconds();

            const std::filesystem::path folder = answers_folder(scene.name(), map.method.name);
            prepare_output_folder("--out", plan.out / folder);
            const std::filesystem::path file = folder / fmt::format("{}-{}.f32", hits, seed);
            write_binary(plan.out / file, answers.data(), answers.size() * sizeof(common::Rgb));
            row["answers"] = file.string();
            run.rows.push_back(std::move(row));
        });
        store = StudyStore();
    }
    if (common::interrupted()) return {{}, true};
    return run;
}

}  // namespace bench
