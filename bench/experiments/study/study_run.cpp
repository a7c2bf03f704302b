#include "bench/experiments/study/study_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/contenders/direct_light.h"
#include "bench/contenders/light_map.h"
#include "bench/contenders/memory_need.h"
#include "bench/contenders/row_facts.h"
#include "bench/contenders/trace_into.h"
#include "bench/setup/output_folder.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"
#include "common/core/stopwatch.h"

namespace bench::study {
namespace {

using Json = nlohmann::ordered_json;

/// What all methods of a run share.
struct RunFacts {
    std::string scene;
    std::uint64_t hits_asked, seed;
    common::TraceReport trace;
};

Json row_start(const RunFacts& facts, const Contender& contender, const ContenderSettings& settings) {
    const LightMapTechnique* light_map = contender.light_map();
    Json row = {{"scene", facts.scene}};
    add_facts(row, contender);
    row["texels"] = light_map ? light_map->texel_choice(settings).count : 0;
    row["hits_asked"] = facts.hits_asked;
    row["seed"] = facts.seed;
    add_run_facts(row, settings);
    return row;
}

Json row_of(const RunFacts& facts, const Contender& contender, const ContenderSettings& settings,
            const StoreFacts& store, const FilledStore& filled) {
    Json row = row_start(facts, contender, settings);
    row["hits"] = facts.trace.hits;
    row["photons_emitted"] = facts.trace.fates.emitted;
    row["trace_seconds"] = facts.trace.trace_seconds;
    row["prepare_seconds"] = filled.preparation.seconds;
    row["prepare_bytes"] = filled.preparation.bytes;
    row["insert_seconds"] = filled.seconds();
    row["insert_bytes"] = store.bytes;
    row["hits_rejected"] = store.rejected.total();
    if (contender.light_map()) row["clamped_share"] = store.clamped_share;
    return row;
}

/// Returns the folder of a method's answers, relative to the study's.
std::filesystem::path answers_folder(const std::string& scene, std::string method) {
    std::replace(method.begin(), method.end(), '/', '-');
    return std::filesystem::path("raw") / scene / method;
}

/// Returns why the scene does not provide what the method needs; empty where it does.
std::string trouble_with_scene(const Contender& method, PreparedScene& prepared) {
    try {
        (void)method->prepare(prepared);
        return "";
    } catch (const common::InputError& e) {
        return e.what();
    }
}

/// Returns the groups in batches that fit into memory together, and adds a row with the reason for each
/// method that does not fit alone.
std::vector<std::vector<ContenderGroup>> batches_of(std::vector<ContenderGroup> groups, const StudyPlan& plan,
                                                    PreparedScene& prepared, const RunFacts& facts,
                                                    std::vector<Json>& skipped) {
    std::erase_if(groups, [&](const ContenderGroup& group) {
        std::string reason = reason_to_skip(group.front(), plan.settings, facts.hits_asked, plan.max_bytes);
        if (reason.empty()) reason = trouble_with_scene(group.front(), prepared);
        for (const Contender& method : group) {
            if (reason.empty()) continue;
            skipped.push_back(row_start(facts, method, plan.settings));
            skipped.back()["skipped"] = reason;
        }
        return !reason.empty();
    });
    return in_batches(std::move(groups), plan.max_bytes, [&](const ContenderGroup& group) {
        return needed_bytes(group.front(), plan.settings, facts.hits_asked);
    });
}

/// Finishes and evaluates the map of each contender that the store serves, one after the other.
void ask_all(const FilledStore& filled, const RunFacts& facts, const StudyPlan& plan, ReferenceScene& scene,
             std::vector<Json>& rows) {
    const StoreFacts store = filled.store->facts();
    for (const Contender& contender : filled.contenders) {
        if (common::interrupted()) return;
        const FinishedMap map =
            finish_with_direct(contender, *filled.store, facts.trace, scene.prepared(), facts.seed);
        Json row = row_of(facts, contender, plan.settings, store, filled);
        row["build_seconds"] = map.build_seconds;
        row["bytes"] = map.answers->bytes();
        const common::Stopwatch gather;
        const std::vector<common::Rgb> answers = ask(*map.answers, scene.points());
        row["gather_seconds"] = gather.seconds();

        const std::filesystem::path folder = answers_folder(scene.name(), contender.name);
        prepare_output_folder("--out", plan.out / folder);
        const std::filesystem::path file = folder / fmt::format("{}-{}.f32", facts.hits_asked, facts.seed);
        write_binary(plan.out / file, answers.data(), answers.size() * sizeof(common::Rgb));
        row["answers"] = file.string();
        rows.push_back(std::move(row));
    }
}

/// Traces into the stores of one batch and asks their maps. Returns false if the user interrupted it; there
/// are no rows of the batch then.
bool run_batch(std::vector<ContenderGroup> groups, RunFacts facts, const StudyPlan& plan,
               ReferenceScene& scene, std::vector<Json>& rows) {
    // The first store finds a wave's hits in cache but not its own sums, so each seed begins with another
    // store.
    std::rotate(groups.begin(), groups.begin() + facts.seed % groups.size(), groups.end());
    std::vector<FilledStore> stores;
    for (ContenderGroup& group : groups)
        stores.emplace_back(std::move(group), scene.prepared(), scene.source());
    common::Progress progress(
        fmt::format("{} {:g} seed {}", scene.name(), static_cast<double>(facts.hits_asked), facts.seed),
        "hits", facts.hits_asked);
    facts.trace = trace_into(stores, {scene.loaded().rays,
                                      scene.source(),
                                      facts.seed,
                                      {.hits = facts.hits_asked},
                                      [&](const common::TraceReport& so_far) {
                                          progress.show(so_far.hits);
                                          return !common::interrupted();
                                      },
                                      {},
                                      recorded_hits(plan.settings.direct)});
    std::vector<Json> asked;
    for (FilledStore& filled : stores) {
        if (common::interrupted()) return false;
        ask_all(filled, facts, plan, scene, asked);
        filled.store.reset();
    }
    if (common::interrupted()) return false;
    std::move(asked.begin(), asked.end(), std::back_inserter(rows));
    return true;
}

}  // namespace

StudyRun run_study(const StudyPlan& plan, ReferenceScene& scene, const std::vector<Contender>& methods,
                   std::uint64_t hits, std::uint64_t seed) {
    StudyRun run;
    const RunFacts facts{scene.name(), hits, seed, {}};
    for (std::vector<ContenderGroup>& batch :
         batches_of(groups_of(methods), plan, scene.prepared(), facts, run.rows)) {
        run.interrupted = !run_batch(std::move(batch), facts, plan, scene, run.rows);
        if (run.interrupted) break;
    }
    if (run.interrupted) std::erase_if(run.rows, [](const Json& row) { return row.contains("skipped"); });
    return run;
}

}  // namespace bench::study
