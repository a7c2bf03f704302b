#include "bench/fit/fit.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/app/output_folder.h"
#include "bench/app/warnings.h"
#include "bench/fit/fit_table.h"
#include "common/core/threads.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

FitVerification verification(const FitPlan& plan, const fit::FitResult& result, StudyScene& scene) {
    const auto runs_of = [&](const fit::Choice& choice) {
        if (!choice.reached) return std::vector<fit::VerifiedRun>{};
        return fit::verify(result.candidates[choice.proposal.candidate],
                           static_cast<std::uint64_t>(choice.proposal.hits), plan.seed, plan.seeds, scene);
    };
    return {runs_of(result.light_map), runs_of(result.photon_map), scene.reference_error()};
}

void say(const FitPlan& plan, const Json& document, bool as_json) {
    const std::string json = document.dump(2, ' ', false, Json::error_handler_t::replace);  // odd file names
    if (plan.out) {
        write_text(*plan.out / "fit.json", json + "\n");
        write_text(*plan.out / "fit.md", fit_as_markdown(document));
    }
    fmt::print("{}", as_json ? json + "\n" : fit_as_text(document));
    if (plan.out && !as_json) fmt::print("\n{}\n", (*plan.out / "fit.json").string());
}

fit::FitResult search(const FitPlan& plan, const LoadedScene& loaded, const common::PhotonSource& source,
                      PreparedMethods& prepared) {
    print_scene_warnings(loaded);
    print_lightmap_warnings(loaded, prepared);
    const fit::FitPoints points = fit::find_fit_points(loaded);
    return fit::search({loaded, source, prepared, points, plan.seed, plan.max_bytes}, plan.goal,
                       {plan.pilot_hits});
}

Json fitted(const FitPlan& plan) {
    if (plan.reference) {  // read first: what cannot be verified is not to be found out after the search
        StudyScene scene(plan.file, *plan.reference, plan.scene, plan.settings);
        const fit::FitResult result = search(plan, scene.loaded(), scene.source(), scene.prepared());
        return fit_as_json(plan, scene.loaded().scene, result, verification(plan, result, scene));
    }
    const LoadedScene loaded(plan.file, plan.scene);
    const common::PhotonSource source(loaded.scene);
    PreparedMethods prepared(loaded, plan.settings);
    return fit_as_json(plan, loaded.scene, search(plan, loaded, source, prepared), {});
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
