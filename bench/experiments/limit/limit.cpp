// shlmbench limit: compares tracing with Embree alone on the same rays.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/contenders/memory_need.h"
#include "bench/contenders/warnings.h"
#include "bench/experiments/limit/limit_figures.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/numbers.h"
#include "bench/setup/run_options.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"

namespace bench::limit {
namespace {

using Json = nlohmann::ordered_json;

struct LimitOptions {
    std::string file, light_map = "shlm", photon_map = "photonmap/compact", hits = "2e6";
    TexelOptions texels;
    int repeat = 9;
    SceneOptions scene;
    RunOptions run;
    bool json = false;
};

/// The checked options.
struct LimitPlan {
    const LimitOptions& options;
    Contender light_map, photon_map;
    ContenderSettings settings;
    std::uint64_t hits;
    std::size_t max_ray_bytes;  ///< limit for the rays while they are recorded and sorted
};

LimitPlan make_plan(const LimitOptions& options) {
    LimitPlan plan{options,
                   parse_contender("--shlm", options.light_map),
                   parse_contender("--photonmap", options.photon_map),
                   {.texels = options.texels.choice()},
                   parse_count("--hits", options.hits),
                   default_max_bytes()};
    if (!plan.light_map.light_map()) throw common::InputError("--shlm: a light map, shlm/...");
    if (!plan.photon_map.photon_map()) throw common::InputError("--photonmap: a photon map, photonmap/...");
    // Odd, so that the median is a ratio that was measured.
    if (options.repeat < 3 || options.repeat > 999 || options.repeat % 2 == 0)
        throw common::InputError("--repeat: an odd number from 3 to 999");
    std::size_t largest = 0;
    for (const Contender& method : {plan.light_map, plan.photon_map}) {
        require_memory(method, plan.settings, plan.hits, plan.max_ray_bytes);
        largest = std::max(largest, needed_bytes(method, plan.settings, plan.hits));
    }
    plan.max_ray_bytes -= largest;
    return plan;
}

void stop_if_interrupted() {
    if (common::interrupted())
        throw Interrupted("limit stopped: nothing is kept, a part of the repetitions is no figure");
}

RecordedRun record(const LimitPlan& plan, const LoadedScene& loaded, const common::PhotonSource& source) {
    common::Progress progress("recording rays", "hits", plan.hits);
    RecordedRun run = record_run(loaded.rays, source, plan.options.run.seed, plan.hits,
                                 plan.max_ray_bytes / 2, [&](const RecordedRun& so_far) {
                                     progress.show(so_far.report.hits);
                                     return !common::interrupted();
                                 });
    stop_if_interrupted();
    return run;
}

LimitSeconds measure(const LimitSubject& subject, std::size_t repetitions) {
    common::Progress progress("limit", "rays", repetitions * limit_part_names.size() * subject.run.rays);
    LimitSeconds seconds = measure_limit(subject, repetitions, [&](std::size_t parts) {
        progress.show(parts * subject.run.rays);
        return !common::interrupted();
    });
    stop_if_interrupted();
    return seconds;
}

void run(const LimitOptions& options) {
    const LimitPlan plan = make_plan(options);
    const int threads = options.run.thread_count();
    common::ThreadPool pool(threads);
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        const common::PhotonSource source(loaded.rays);
        PreparedScene prepared(loaded, plan.settings);
        for (const Contender& contender : {plan.light_map, plan.photon_map})
            (void)contender->prepare(prepared);  // outside the timed parts
        print_scene_warnings(loaded);
        print_light_warnings(loaded, source);
        print_lightmap_warnings(loaded, prepared);

        RecordedRun recorded = record(plan, loaded, source);
        std::vector<RayBlock> sorted = sorted_blocks(recorded.blocks, loaded.scene.bounds);
        const LimitSubject subject{loaded,
                                   source,
                                   prepared,
                                   plan.light_map,
                                   plan.photon_map,
                                   options.run.seed,
                                   std::move(recorded),
                                   std::move(sorted)};
        check_answers(subject);
        stop_if_interrupted();
        const LimitSeconds seconds = measure(subject, static_cast<std::size_t>(options.repeat));
        if (options.json)
            common::print_result(fmt::format(
                "{}\n", limit_as_json(subject, seconds, threads)
                            .dump(2, ' ', false, Json::error_handler_t::replace)));  // odd file names
        else
            common::print_result(limit_as_text(subject, seconds, threads));
    });
}

const RegisteredCommand registered(
    10, {.name = "limit",
         .purpose = "Say how near tracing comes to Embree alone with the same rays",
         .add_to = [](Command& command) -> std::function<void()> {
             const auto options = std::make_shared<LimitOptions>();
             command.option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb", Need::required);
             command.option("--hits", options->hits,
                            "The run: as many photons as make at least this many hits");
             command.option("--shlm", options->light_map, "Which light map: shlm/...");
             command.option("--photonmap", options->photon_map, "Which photon map: photonmap/...");
             options->texels.add_to(command);
             command.whole_number("--repeat", options->repeat, "Repetitions, an odd number");
             options->scene.add_to(command);
             options->run.add_to(command);
             command.flag("--json", options->json, "Print JSON");
             return [options] { run(*options); };
         }});

}  // namespace

}  // namespace bench::limit
