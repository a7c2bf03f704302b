#include "bench/fit/fit.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/app/output_folder.h"
#include "bench/app/python.h"
#include "bench/app/warnings.h"
#include "bench/fit/explanation_table.h"
#include "bench/fit/fit_table.h"
#include "common/core/input_error.h"
#include "common/core/threads.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

/// What a fit works on. All must outlive it.
struct FitScene {
    const LoadedScene& loaded;
    const common::PhotonSource& source;
    PreparedMethods& prepared;
    StudyScene* with_reference;  ///< null: nothing is verified
};

/// What a fit has to say.
struct FitDocuments {
    Json fit;
    Json picture;  ///< of the explanation; null where none was asked for
};

FitVerification verification(const FitPlan& plan, const fit::FitResult& result, StudyScene& scene) {
    const auto runs_of = [&](const fit::Choice& choice) {
        if (!choice.reached) return std::vector<fit::VerifiedRun>{};
        return fit::verify(result.candidates[choice.proposal.candidate],
                           static_cast<std::uint64_t>(choice.proposal.hits), plan.seed, plan.seeds, scene);
    };
    return {runs_of(result.light_map), runs_of(result.photon_map), scene.reference_error()};
}

FitDocuments fitted(const FitPlan& plan, const FitScene& scene) {
    print_scene_warnings(scene.loaded);
    print_lightmap_warnings(scene.loaded, scene.prepared);
    const fit::FitPoints points = fit::find_fit_points(scene.loaded);
    const fit::PilotSubject subject{scene.loaded, scene.source, scene.prepared,
                                    points,       plan.seed,    plan.max_bytes};
    const fit::FitResult result = fit::search(subject, plan.goal, {plan.pilot_hits});
    const FitVerification verified =
        scene.with_reference ? verification(plan, result, *scene.with_reference) : FitVerification{};
    FitDocuments documents{fit_as_json(plan, scene.loaded.scene, result, verified), {}};
    if (plan.explain) {
        const fit::Explanation explanation = fit::explain(result, subject);
        documents.fit["explanation"] = explanation_as_json(explanation, scene.loaded.scene);
        documents.picture = picture_as_json(explanation, documents.fit);
    }
    return documents;
}

FitDocuments fitted(const FitPlan& plan) {
    if (plan.reference) {  // read first: what cannot be verified is not to be found out after the search
        StudyScene scene(plan.file, *plan.reference, plan.scene, plan.settings);
        return fitted(plan, {scene.loaded(), scene.source(), scene.prepared(), &scene});
    }
    const LoadedScene loaded(plan.file, plan.scene);
    const common::PhotonSource source(loaded.scene);
    PreparedMethods prepared(loaded, plan.settings);
    return fitted(plan, {loaded, source, prepared, nullptr});
}

std::string as_text(const Json& document, int indent) {
    return document.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";  // odd file names
}

void write(const std::filesystem::path& folder, const FitDocuments& documents) {
    write_text(folder / "fit.json", as_text(documents.fit, 2));
    write_text(folder / "fit.md", fit_as_markdown(documents.fit));
    if (documents.picture.is_null()) return;
    write_text(folder / "explanation.json", as_text(documents.picture, -1));
    if (!run_python("bench/report/explanation_chart.py", folder))
        throw common::InputError("fit: the picture of --explain could not be drawn");
}

void say(const FitPlan& plan, const FitDocuments& documents, bool as_json) {
    if (plan.out) write(*plan.out, documents);
    fmt::print("{}", as_json ? as_text(documents.fit, 2) : fit_as_text(documents.fit));
    if (plan.out && !as_json) fmt::print("\n{}\n", (*plan.out / "fit.json").string());
}

void run(const FitOptions& options) {
    if (options.list) {
        for (const std::string& name : fit::grid_names()) fmt::print("{}\n", name);
        return;
    }
    const FitPlan plan = make_plan(options);
    common::ThreadPool pool(plan.threads);
    pool.run([&] { say(plan, fitted(plan), options.json); });
}

}  // namespace

void add_fit_command(CLI::App& app) {
    const auto options = std::make_shared<FitOptions>();
    CLI::App* command = app.add_subcommand(
        "fit", "Find the settings that reach an error at least cost, without seeing a reference");
    options->add_to(*command);
    command->callback([options] { run(*options); });
}

}  // namespace bench
