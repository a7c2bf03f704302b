#include "bench/experiments/study/study_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/contenders/memory_need.h"
#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "bench/setup/output_folder.h"
#include "common/core/input_error.h"
#include "common/gltf/source_files.h"

namespace bench::study {
namespace {

std::vector<Contender> grouped_by_store(std::vector<Contender> methods) {
    for (auto first = methods.begin(); first != methods.end();)
        first = std::stable_partition(first, methods.end(),
                                      [store = *first](const Contender& m) { return share_store(m, store); });
    return methods;
}

std::vector<std::filesystem::path> inputs_of(const StudyPlan& plan) {
    std::vector<std::filesystem::path> inputs;
    for (const std::filesystem::path& file : plan.files) {
        for (std::filesystem::path& source : common::source_files(file)) inputs.push_back(std::move(source));
        inputs.push_back(plan.reference_of(file));
    }
    return inputs;
}

}  // namespace

void StudyOptions::add_to(Command& command) {
    command.option("SCENE", files, "glTF 2.0 files, .gltf or .glb", Need::required);
    command.option("--hits", hits, "Numbers of hits, separated by commas");
    command.option("--methods", methods, "Methods, separated by commas");
    command.option(
        "--references", references,
        "Folder with SCENE.exr of each scene, made by shlmbench reference; their size is the study's");
    command.option("--out", out, "Folder for study.json, raw answers, charts and report");
    command.option("--max-memory", max_memory,
                   "Methods that would need more are not started; default: 9/10 of what is free");
    command.whole_number("--seeds", seeds, "Independent runs of each size: seeds 1 to this");
    command.flag("--anew", anew,
                 "Begin again where the folder's rows are of another build, machine or setting");
    add_threads_option(command, threads);
    scene.add_to(command);
    method_options.add_to(command);
    direct.add_to(command);
    emission.add_to(command);
}

StudyPlan make_plan(const StudyOptions& options) {
    StudyPlan plan{
        .files = {options.files.begin(), options.files.end()},
        .hits = parse_sizes("--hits", parse_list("--hits", options.hits)),
        .methods = grouped_by_store(parse_contenders("--methods", parse_list("--methods", options.methods))),
        .references = options.references,
        .out = options.out,
        .max_bytes = options.max_memory.empty() ? default_max_bytes()
                                                : parse_bytes("--max-memory", options.max_memory),
        .seeds = options.seeds,
        .anew = options.anew,
        .scene = options.scene,
        .settings = options.method_options.settings(),
        .threads = RunOptions{.threads = options.threads}.thread_count(),
    };
    plan.settings.direct = options.direct.setting();
    plan.settings.emission = options.emission.sequence();
    require_different_names(options.files);
    if (plan.seeds < 1 || plan.seeds > 1000) throw common::InputError("--seeds: from 1 to 1000");
    std::error_code unreadable;
    for (const std::filesystem::path& file : plan.files)
        if (!std::filesystem::is_regular_file(plan.reference_of(file), unreadable))
            throw common::InputError(
                fmt::format("--references: there is no {}; shlmbench reference {} makes it",
                            plan.reference_of(file).string(), file.string()));
    check_results("--out", plan.out,
                  {"study.json", {"report.md", "summary.json"}, {"raw", "charts", "images"}},
                  inputs_of(plan));
    prepare_output_folder("--out", plan.out);
    return plan;
}

}  // namespace bench::study
