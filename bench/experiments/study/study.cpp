// shlmbench study: measures error, time and bytes over methods, hits and seeds.
#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench/contenders/warnings.h"
#include "bench/experiments/study/study_plan.h"
#include "bench/experiments/study/study_run.h"
#include "bench/experiments/study/study_table.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/report.h"
#include "common/core/input_error.h"
#include "common/core/output_lock.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"

namespace bench::study {
namespace {

/// A temporary folder of this process, which is removed with its contents.
class ScratchFolder {
  public:
    explicit ScratchFolder(const std::filesystem::path& where) : path_((where / ".warm-up-XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr)
            throw common::InputError(fmt::format("--out: {} cannot be written to", where.string()));
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// Traces briefly without measuring, since the first run of a process has cold caches, buffers and threads.
void warm_up(const StudyPlan& plan, ReferenceScene& scene) {
    const ScratchFolder folder(plan.out);
    StudyPlan scratch = plan;
    scratch.out = folder.path();
    (void)run_study(scratch, scene, plan.methods, 10'000, 2);
}

/// Returns false if the user interrupted it.
bool study_scene(const StudyPlan& plan, const std::filesystem::path& file, std::uint64_t hits,
                 StudyTable& table) {
    if (!table.is_missing_any(file.stem().string(), plan.methods, hits, plan.seeds)) return true;
    ReferenceScene scene(file, plan.reference_of(file), plan.scene, plan.settings);
    print_scene_warnings(scene.loaded());
    print_light_warnings(scene.loaded(), scene.source());
    print_lightmap_warnings(scene.loaded(), scene.prepared());
    table.describe_scene(scene.name(), scene.facts());
    warm_up(plan, scene);
    for (std::uint64_t seed = 1; seed <= plan.seeds; ++seed) {
        const std::vector<Contender> methods = table.missing(scene.name(), plan.methods, hits, seed);
        if (methods.empty()) continue;
        const StudyRun run = run_study(plan, scene, methods, hits, seed);
        if (!run.rows.empty()) table.add(run.rows);
        if (run.interrupted) return false;
    }
    return true;
}

/// Recomputes the visible error of the stored answers and the facts of the reference, so that both are up to
/// date when the reference has been improved.
void compare_with_reference(const StudyPlan& plan, const std::filesystem::path& file, StudyTable& table) {
    const ReferenceScene scene(file, plan.reference_of(file), plan.scene, plan.settings);
    scene.write_reference(plan.out / "raw" / scene.name());
    table.describe_scene(scene.name(), scene.facts());
    table.change_rows(scene.name(), [&](nlohmann::ordered_json& row) {
        if (row["seed"] != 1) return;
        const std::filesystem::path answers = plan.out / row["answers"].get<std::string>();
        row["flip"] = scene.write_pictures(answers.parent_path(), row["hits_asked"].get<std::uint64_t>(),
                                           read_answers(answers, scene.points().size()));
    });
}

void run(const StudyOptions& options) {
    const StudyPlan plan = make_plan(options);
    const common::OutputLock lock("--out", plan.out / "study.json");
    common::ThreadPool pool(plan.threads);
    pool.run([&] {
        StudyTable table(plan);
        // Small sizes of all scenes come first, so that early results are complete, if coarse.
        for (const std::uint64_t hits : plan.hits)
            for (const std::filesystem::path& file : plan.files)
                if (!study_scene(plan, file, hits, table))
                    throw Interrupted(fmt::format("study stopped: {} finished rows are in {}",
                                                  table.row_count(), table.file().string()));
        for (const std::filesystem::path& file : plan.files) compare_with_reference(plan, file, table);
        if (!write_report("study", plan.out))
            throw std::runtime_error("study: the report could not be written; the table is complete");
        common::print_result(fmt::format("{}: {} rows\n", table.file().string(), table.row_count()));
    });
}

const RegisteredCommand registered(
    7, {.name = "study",
        .purpose = "Measure error beside time and bytes, over methods, numbers of hits and seeds",
        .add_to = [](Command& command) -> std::function<void()> {
            const auto options = std::make_shared<StudyOptions>();
            options->add_to(command);
            return [options] { run(*options); };
        }});

}  // namespace

}  // namespace bench::study
