#include "bench/experiments/compare/compare_plan.h"

#include <fmt/format.h>

#include "bench/contenders/memory_need.h"
#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "bench/setup/output_folder.h"
#include "common/core/input_error.h"
#include "common/gltf/source_files.h"

namespace bench::compare {
void CompareOptions::add_to(Command& command) {
    command.option("SCENE", files, "glTF 2.0 files, .gltf or .glb", Need::required);
    command.option("--hits", hits, "Numbers of hits, separated by commas");
    command.option("--methods", methods, "Methods, separated by commas");
    command.option("--out", out, "Folder for compare.json, compare.csv, charts and images");
    command.option(
        "--max-memory", max_memory,
        "Methods that would need more are not started, and ended where they grow past it; default: 9/10 "
        "of what is free");
    command.whole_number("--repetitions", repetitions,
                         "Runs of each method, interleaved; the table has medians");
    command.number("--seconds-per-size", seconds_per_size,
                   "Fewer repetitions where one scene and number of hits would take longer");
    scene.add_to(command);
    method_options.add_to(command);
    direct.add_to(command);
    emission.add_to(command);
    run.add_to(command);
}

ComparePlan make_plan(const CompareOptions& options) {
    require_different_names(options.files);
    ComparePlan plan{.files = options.files,
                     .hits = parse_sizes("--hits", parse_list("--hits", options.hits)),
                     .methods = parse_contenders("--methods", parse_list("--methods", options.methods)),
                     .out = options.out,
                     .max_bytes = options.max_memory.empty()
                                      ? default_max_bytes()
                                      : parse_bytes("--max-memory", options.max_memory),
                     .repetitions = options.repetitions,
                     .seconds_per_size = options.seconds_per_size,
                     .scene = options.scene,
                     .settings = options.method_options.settings(),
                     .threads = options.run.thread_count(),
                     .seed = options.run.seed};
    plan.settings.direct = options.direct.setting();
    plan.settings.emission = options.emission.sequence();
    if (plan.repetitions < 1 || plan.repetitions > 10'000)
        throw common::InputError("--repetitions: from 1 to 10000");
    if (!(plan.seconds_per_size >= 0)) throw common::InputError("--seconds-per-size: must not be negative");
    std::vector<std::filesystem::path> inputs;
    for (const std::string& file : plan.files)
        for (std::filesystem::path& source : common::source_files(file)) inputs.push_back(std::move(source));
    check_results("--out", plan.out, {"compare.json", {"compare.csv"}, {"charts", "images"}}, inputs);
    prepare_output_folder("--out", plan.out);
    return plan;
}

}  // namespace bench::compare
