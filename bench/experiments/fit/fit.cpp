// shlmbench fit: finds the settings that reach an error at least cost, without a reference.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/contenders/warnings.h"
#include "bench/experiments/fit/explanation_table.h"
#include "bench/experiments/fit/fit_table.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/report.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/output_lock.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"

namespace bench::fit {
namespace {

using Json = nlohmann::ordered_json;

/// What a fit works on. Whatever it refers to must outlive it.
struct FitScene {
    PilotSubject subject;
    ReferenceScene* with_reference;  ///< null: nothing is verified
};

/// The results of a fit.
struct FitDocuments {
    Json fit;
    Json models;
    Json picture;  ///< of the explanation; null where none was asked for
};

FitVerification verification(const FitPlan& plan, const FitResult& result, ReferenceScene& scene) {
    const auto runs_of = [&](const Decision& decision) {
        const Choice& choice = decision.choice;
        if (!choice.reached) return std::vector<VerifiedRun>{};
        return verify(result.candidates[choice.proposal.candidate],
                      static_cast<std::uint64_t>(choice.proposal.hits), plan.seed, plan.seeds, scene);
    };
    return {runs_of(result.light_map), runs_of(result.photon_map), scene.reference_error()};
}

void add_explanation(const FitResult& result, const PilotSubject& subject, FitDocuments& documents) {
    try {
        const Explanation explanation = explain(result, subject);
        documents.fit["explanation"] = explanation_as_json(explanation, subject.loaded.scene);
        documents.picture = picture_as_json(explanation, documents.fit);
    } catch (const Stopped&) {  // by the user: the answer is valid without it
    }
}

FitDocuments fitted(const FitPlan& plan, const FitGoal& goal, const FitScene& scene, PilotArchive& archive) {
    const FitResult result = search(archive, goal, {plan.pilot_hits, plan.seconds});
    const FitVerification verified =
        scene.with_reference ? verification(plan, result, *scene.with_reference) : FitVerification{};
    FitDocuments documents{
        fit_as_json(plan, goal, scene.subject.loaded.scene, result, verified), models_as_json(result), {}};
    if (plan.explain) add_explanation(result, scene.subject, documents);
    return documents;
}

std::string as_text(const Json& document, int indent) {
    return document.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";  // odd file names
}

void write(const std::filesystem::path& folder, const FitDocuments& documents) {
    prepare_output_folder("--out", folder);
    write_text(folder / "fit.json", as_text(documents.fit, 2));
    write_text(folder / "fit.md", fit_as_markdown(documents.fit));
    write_text(folder / "models.json", as_text(documents.models, -1));
    if (documents.picture.is_null()) return;
    write_text(folder / "explanation.json", as_text(documents.picture, -1));
    if (!write_report("explanation", folder))
        throw common::InputError("fit: the picture of --explain could not be drawn");
}

void say(const FitPlan& plan, const FitGoal& goal, const FitDocuments& documents, bool as_json) {
    if (plan.out) write(plan.folder_of(goal), documents);
    common::print_result(as_json ? as_text(documents.fit, 2) : fit_as_text(documents.fit));
    if (plan.out && !as_json)
        common::print_result(fmt::format("\n{}\n\n", (plan.folder_of(goal) / "fit.json").string()));
    std::fflush(stdout);  // the next goal may take minutes
}

void fit_all(const FitPlan& plan, const LoadedScene& loaded, const common::PhotonSource& source,
             PreparedScene& prepared, ReferenceScene* with_reference, bool as_json) {
    print_scene_warnings(loaded);
    print_light_warnings(loaded, source);
    print_lightmap_warnings(loaded, prepared);
    const FitPoints points = find_fit_points(loaded);
    const FitScene scene{{loaded, source, prepared, points, plan.seed, plan.max_bytes}, with_reference};
    PilotArchive archive(scene.subject);
    for (const FitGoal& goal : plan.goals) {
        say(plan, goal, fitted(plan, goal, scene, archive), as_json);
        if (common::interrupted())
            throw Interrupted("fit stopped: the last answer is what was known by then");
    }
}

void fit_all(const FitPlan& plan, bool as_json) {
    if (plan.reference) {  // read first, so that a bad reference fails before the search
        ReferenceScene scene(plan.file, *plan.reference, plan.scene, plan.settings);
        return fit_all(plan, scene.loaded(), scene.source(), scene.prepared(), &scene, as_json);
    }
    const LoadedScene loaded(plan.file, plan.scene);
    const common::PhotonSource source(loaded.rays);
    PreparedScene prepared(loaded, plan.settings);
    fit_all(plan, loaded, source, prepared, nullptr, as_json);
}

void run(const FitOptions& options) {
    if (options.list) {
        for (const std::string& name : grid_names()) common::print_result(fmt::format("{}\n", name));
        return;
    }
    const FitPlan plan = make_plan(options);
    std::optional<common::OutputLock> lock;
    if (plan.out) lock.emplace("--out", *plan.out / "fit.json");
    common::ThreadPool pool(plan.threads);
    pool.run([&] { fit_all(plan, options.json); });
}

const RegisteredCommand registered(
    11, {.name = "fit",
         .purpose = "Find the settings that reach an error at least cost, without seeing a reference",
         .add_to = [](Command& command) -> std::function<void()> {
             const auto options = std::make_shared<FitOptions>();
             options->add_to(command);
             return [options] { run(*options); };
         }});

}  // namespace

}  // namespace bench::fit
