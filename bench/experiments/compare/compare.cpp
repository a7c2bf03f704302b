// shlmbench compare: measures methods side by side, over scenes and numbers of hits.
#include <fmt/format.h>

#include "bench/contenders/picture.h"
#include "bench/contenders/warnings.h"
#include "bench/experiments/compare/compare_plan.h"
#include "bench/experiments/compare/compare_size.h"
#include "bench/experiments/compare/result_table.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/report.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/output_lock.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"
#include "common/scene/fingerprint.h"

namespace bench::compare {
namespace {

namespace fs = std::filesystem;

constexpr int image_width = 640, image_height = 360;

/// A method's picture of the scene, at the largest number of hits that the method was run with.
struct Picture {
    Contender method;
    std::uint64_t hits = 0;
    fs::path file;
};

std::vector<Picture> pictures_of(const ComparePlan& plan, const std::string& scene,
                                 const nlohmann::ordered_json& rows) {
    std::vector<Picture> pictures;
    for (const Contender& method : plan.methods) {
        if (method->fields()["engine"] == "flann-incremental") continue;  // same as photonmap/flann, slower
        Picture picture{method, 0, {}};
        for (const auto& row : rows)
            if (row["scene"] == scene && row["method"] == method.name && !row.contains("skipped"))
                picture.hits = std::max(picture.hits, row["hits_asked"].get<std::uint64_t>());
        std::string name = method.name;
        std::replace(name.begin(), name.end(), '/', '-');
        picture.file = plan.out / "images" / fmt::format("{}-{}.png", scene, name);
        if (picture.hits > 0) pictures.push_back(picture);
    }
    return pictures;
}

/// Draws all pictures with the same exposure. Ends early if the user interrupts it.
void draw(const ComparePlan& plan, const CompareScene& scene, const std::vector<Picture>& pictures) {
    prepare_output_folder("--out", plan.out / "images");
    std::error_code ignored;
    for (const Picture& picture : pictures) fs::remove(picture.file, ignored);  // older ones must not stay
    const auto pixels =
        common::visible_surfaces(scene.loaded.rays, scene.loaded.camera, image_width, image_height);
    float exposure = 0;
    for (const Picture& picture : pictures) {
        const auto go_on = [](const common::TraceReport&) { return !common::interrupted(); };
        const TracedRun run{scene.loaded.rays,
                            scene.source,
                            plan.seed,
                            {.hits = picture.hits},
                            go_on,
                            {},
                            recorded_hits(plan.settings.direct)};
        const common::Image image =
            render_run(picture.method, scene.prepared, run, pixels, image_width, image_height);
        if (common::interrupted()) return;
        if (exposure == 0) exposure = common::middle_grey_exposure(image);
        common::write_png(picture.file, image, exposure);
    }
}

/// Returns false if the user interrupted it.
bool compare_scene(const ComparePlan& plan, const std::string& file, ResultTable& table) {
    const LoadedScene loaded(file, plan.scene);
    const common::PhotonSource source(loaded.rays, plan.settings.emission);
    const QueryPoints queries = visible_query_points(loaded, plan.seed);
    PreparedScene prepared(loaded, plan.settings);
    print_scene_warnings(loaded);
    print_light_warnings(loaded, source);
    print_lightmap_warnings(loaded, prepared);
    const CompareScene scene{loaded, source, queries, prepared, common::fingerprint(loaded.scene)};
    table.keep_one_version_of(loaded.name, scene.fingerprint);
    bool anything_new = false;
    for (std::uint64_t hits : plan.hits) {
        std::vector<Contender> methods;
        std::copy_if(plan.methods.begin(), plan.methods.end(), std::back_inserter(methods),
                     [&](const Contender& method) { return !table.has(loaded.name, method.name, hits); });
        if (methods.empty()) continue;
        const SizeResult result = compare_size(plan, scene, methods, hits);
        table.add(result.rows);
        if (result.interrupted) return false;
        anything_new = true;
    }
    const std::vector<Picture> pictures = pictures_of(plan, loaded.name, table.rows());
    const bool all_there = std::all_of(pictures.begin(), pictures.end(),
                                       [](const Picture& picture) { return fs::exists(picture.file); });
    if (anything_new || !all_there) draw(plan, scene, pictures);
    return !common::interrupted();
}

/// Loads every scene but the first, which is loaded next anyway. An unusable scene must be found before hours
/// are spent on the others.
void check_scenes(const ComparePlan& plan) {
    for (const std::string& file : std::span(plan.files).subspan(1)) {
        const LoadedScene loaded(file, plan.scene);
        const common::PhotonSource source(loaded.rays);
        (void)visible_query_points(loaded, plan.seed);
    }
}

void run(const CompareOptions& options) {
    const ComparePlan plan = make_plan(options);
    const common::OutputLock lock("--out", plan.out / "compare.json");
    common::ThreadPool pool(plan.threads);
    pool.run([&] {
        check_scenes(plan);
        ResultTable table(plan);
        for (const std::string& file : plan.files)
            if (!compare_scene(plan, file, table))
                throw Interrupted(fmt::format("compare stopped: {} finished rows are in {}",
                                              table.rows().size(), (plan.out / "compare.json").string()));
        common::print_result(rows_as_text(table.rows()));
        common::print_result(fmt::format("\n{}\n", (plan.out / "compare.json").string()));
        if (!write_report("compare", plan.out))
            throw std::runtime_error("compare: the charts could not be drawn; the table is complete");
    });
}

const RegisteredCommand registered(6,
                                   {.name = "compare",
                                    .purpose = "Measure the methods side by side as the number of hits grows",
                                    .add_to = [](Command& command) -> std::function<void()> {
                                        const auto options = std::make_shared<CompareOptions>();
                                        options->add_to(command);
                                        return [options] { run(*options); };
                                    }});

}  // namespace

}  // namespace bench::compare
