#include "bench/compare/compare.h"

#include <fmt/format.h>

#include <cstdlib>

#include "bench/app/build_info.h"
#include "bench/app/provenance.h"
#include "bench/compare/compare_plan.h"
#include "bench/compare/compare_size.h"
#include "bench/compare/output_folder.h"
#include "bench/compare/result_table.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/threads.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr int image_width = 640, image_height = 360;

/// Each method's picture at the most hits that it was run with, all with the same exposure. Ends early where
/// the user wants it to.
void draw_images(const ComparePlan& plan, const CompareScene& scene, const nlohmann::ordered_json& rows) {
    const fs::path folder = plan.out / "images";
    prepare_output_folder("--out", folder);
    const auto pixels =
        common::visible_surfaces(scene.loaded.rays, scene.loaded.camera, image_width, image_height);
    float exposure = 0;
    for (const std::string& method : plan.methods) {
        if (method == "photonmap/flann-incremental") continue;  // photonmap/flann's picture, slower
        std::uint64_t hits = 0;
        for (const auto& row : rows)
            if (row["scene"] == scene.loaded.name && row["method"] == method && !row.contains("skipped"))
                hits = std::max(hits, row["hits_asked"].get<std::uint64_t>());
        if (hits == 0) continue;
        const auto go_on = [](const common::TraceReport&) { return !common::interrupted(); };
        const Workload workload{scene.loaded, scene.source, scene.queries, plan.seed, {.hits = hits}, go_on};
        const common::Image image =
            render_method(method, scene.prepared, workload, pixels, image_width, image_height);
        if (common::interrupted()) return;
        if (exposure == 0) exposure = common::middle_grey_exposure(image);
        std::string name = method;
        std::replace(name.begin(), name.end(), '/', '-');
        common::write_png(folder / fmt::format("{}-{}.png", scene.loaded.name, name), image, exposure);
    }
}

/// False where the user ended it.
bool compare_scene(const ComparePlan& plan, const std::string& file, ResultTable& table) {
    const LoadedScene loaded(file, plan.scene);
    const common::PhotonSource source(loaded.scene);
    const QueryPoints queries = visible_query_points(loaded, plan.seed);
    PreparedMethods prepared(loaded, plan.settings);
    print_warnings(loaded, prepared, true);
    const CompareScene scene{loaded, source, queries, prepared};
    bool anything_new = false;
    for (std::uint64_t hits : plan.hits) {
        std::vector<std::string> methods;
        std::copy_if(plan.methods.begin(), plan.methods.end(), std::back_inserter(methods),
                     [&](const std::string& method) { return !table.has(loaded.name, method, hits); });
        if (methods.empty()) continue;
        const SizeResult result = compare_size(plan, scene, methods, hits);
        table.add(result.rows);
        if (result.interrupted) return false;
        anything_new = true;
    }
    if (anything_new) draw_images(plan, scene, table.rows());
    return !common::interrupted();
}

/// Loads every scene but the first, which comes next anyway: one that cannot be used must not come to light
/// after hours spent on those before it.
void check_scenes(const ComparePlan& plan) {
    for (const std::string& file : std::span(plan.files).subspan(1)) {
        const LoadedScene loaded(file, plan.scene);
        const common::PhotonSource source(loaded.scene);
        (void)visible_query_points(loaded, plan.seed);
    }
}

/// Draws the charts with the project's Python script.
void draw_charts(const ComparePlan& plan) {
    const std::string command =
        fmt::format("/usr/bin/python3 '{}/bench/report/charts.py' '{}'", source_folder, plan.out.string());
    if (std::system(command.c_str()) != 0)
        fmt::print(stderr, "compare: the charts could not be drawn; the table is complete\n");
}

void run(const CompareOptions& options) {
    const ComparePlan plan = make_plan(options);
    common::ThreadPool pool(plan.threads);
    pool.run([&] {
        check_scenes(plan);
        ResultTable table(plan);
        for (const std::string& file : plan.files)
            if (!compare_scene(plan, file, table))
                throw Interrupted(fmt::format("compare stopped: {} finished rows are in {}",
                                              table.rows().size(), (plan.out / "compare.json").string()));
        draw_charts(plan);
        fmt::print("{}", rows_as_text(table.rows()));
        fmt::print("\n{}\n", (plan.out / "compare.json").string());
    });
}

}  // namespace

void add_compare_command(CLI::App& app) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command =
        app.add_subcommand("compare", "Measure the methods side by side as the number of hits grows");
    options->add_to(*command);
    command->callback([options] { run(*options); });
}

}  // namespace bench
