#include "bench/experiments/fit/fit_plan.h"

#include <fmt/format.h>

#include "bench/contenders/memory_need.h"
#include "bench/experiments/fit/search.h"
#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/significance.h"
#include "common/core/input_error.h"
#include "common/gltf/source_files.h"

namespace bench::fit {
namespace {

constexpr double confidence = 0.9;  // nine runs of ten meet the target
// Calibrated: with a margin of 1, nine of ten runs on the random rooms 1 to 24 use at most 1.3 of the margin,
// an upper bound over draws of the rooms (results/models/promise/calibration.json, bench/report fit-promise).
constexpr double margin = 1.4;
constexpr double tries = 10;  // how often an adaptive map is tried, by pilots and then with fewer hits
constexpr std::size_t most_seeds = 1000;

FitGoal goal_of(const FitOptions& options, const std::string& target, const std::string& least) {
    FitGoal goal{.target = parse_percentage("--target", target),
                 .z = z_for(2 * (1 - confidence)),
                 .margin = margin,
                 .z_of_tries = z_for(2 * (1 - confidence) / tries),
                 .max_hits = static_cast<double>(parse_count("--max-hits", options.max_hits))};
    if (least != "time" && least != "bytes")
        throw common::InputError(fmt::format("--least: '{}' is neither time nor bytes", least));
    goal.least_bytes = least == "bytes";
    if (!options.budget_bytes.empty())
        goal.budget_bytes = static_cast<double>(parse_bytes("--budget-bytes", options.budget_bytes));
    if (!options.budget_time.empty())
        goal.budget_seconds = parse_seconds("--budget-time", options.budget_time);
    return goal;
}

std::vector<FitGoal> goals_of(const FitOptions& options) {
    std::vector<FitGoal> goals;
    for (const std::string& target : parse_list("--target", options.targets))
        for (const std::string& least : parse_list("--least", options.least))
            goals.push_back(goal_of(options, target, least));
    return goals;
}

void check_folders(const FitPlan& plan) {
    std::vector<std::filesystem::path> inputs = common::source_files(plan.file);
    if (plan.reference) inputs.push_back(*plan.reference);
    for (const FitGoal& goal : plan.goals)
        check_results("--out", plan.folder_of(goal),
                      {"fit.json", {"fit.md", "models.json", "explanation.json", "explanation.png"}, {}},
                      inputs);
}

}  // namespace

std::filesystem::path FitPlan::folder_of(const FitGoal& goal) const {
    if (goals.size() == 1) return *out;
    return *out / fmt::format("{:g}-{}", 100 * goal.target, goal.least());
}

void FitOptions::add_to(Command& command) {
    command.option("SCENE", file, "glTF 2.0 file, .gltf or .glb");
    command.option(
        "--target", targets,
        "The errors to reach, such as 10%,5%; pilots are shared, and --out gets a folder for each");
    command.option("--least", least,
                   "What is to be as little as can be: time, bytes, or time,bytes, one after the other");
    command.option("--budget-bytes", budget_bytes, "Finished maps must be no larger, such as 100MiB");
    command.option("--budget-time", budget_time, "Runs must be no longer, such as 30s");
    command.option("--max-hits", max_hits, "Runs must have no more hits");
    command.option("--time", time,
                   "The search for each target must be no longer, such as 10s: then it answers with what it "
                   "knows, once it knows anything");
    command.option("--pilot", pilot, "Hits of each of the two halves of the pilot, at most");
    command.option("--max-memory", max_memory,
                   "Methods that would need more are not considered; default: 9/10 of what is free");
    command.option("--verify", verify,
                   "A reference of the scene: then trace what was chosen and measure its error");
    command.whole_number("--seeds", seeds, "Runs of each verification, other seeds than the pilot's");
    command.option(
        "--out", out,
        "Folder for fit.json, fit.md, models.json (what is known of every candidate) and the picture of "
        "--explain");
    command.flag("--explain", explain,
                 "Say for each surface what the light map keeps there and what of its error arises there; "
                 "draw it, with --out");
    command.flag("--json", json, "Print JSON");
    command.flag("--list", list, "Print the methods of the grid, for shlmbench study, and do nothing else");
    scene.add_to(command);
    run.add_to(command);
}

FitPlan make_plan(const FitOptions& options) {
    if (options.file.empty()) throw common::InputError("fit: which SCENE?");
    if (options.targets.empty())
        throw common::InputError("--target: which error is to be reached, such as 5%?");
    FitPlan plan{.file = options.file,
                 .goals = goals_of(options),
                 .pilot_hits = parse_count("--pilot", options.pilot),
                 .seconds = options.time.empty() ? std::numeric_limits<double>::infinity()
                                                 : parse_seconds("--time", options.time),
                 .max_bytes = options.max_memory.empty() ? default_max_bytes()
                                                         : parse_bytes("--max-memory", options.max_memory),
                 .reference = {},
                 .seeds = options.seeds,
                 .explain = options.explain,
                 .out = {},
                 .scene = options.scene,
                 .settings = {},
                 .seed = options.run.seed,
                 .threads = options.run.thread_count()};
    if (plan.pilot_hits < fewest_pilot_hits)
        throw common::InputError(fmt::format("--pilot: at least {}", fewest_pilot_hits));
    if (plan.seeds < 1 || plan.seeds > most_seeds)
        throw common::InputError(fmt::format("--seeds: from 1 to {}", most_seeds));
    if (!options.verify.empty()) plan.reference = options.verify;
    if (!options.out.empty()) {
        plan.out = options.out;
        check_folders(plan);
        prepare_output_folder("--out", *plan.out);
    }
    return plan;
}

}  // namespace bench::fit
