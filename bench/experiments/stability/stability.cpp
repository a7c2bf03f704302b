// shlmbench stability: runs the collection of failure cases.
#include <fmt/format.h>

#include <algorithm>

#include "bench/experiments/stability/stability_table.h"
#include "bench/experiments/stability/verdict.h"
#include "bench/setup/command.h"
#include "bench/setup/earlier_rows.h"
#include "bench/setup/ending.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/provenance.h"
#include "bench/setup/report.h"
#include "bench/setup/run_options.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/output_lock.h"
#include "common/core/progress.h"
#include "common/core/standard_streams.h"
#include "common/core/stopwatch.h"
#include "common/core/threads.h"

namespace bench::stability {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct StabilityOptions {
    std::vector<std::string> names;
    std::string out = "results/latest/stability";
    bool list = false;
    bool quick = false;
    int threads = 0;
};

/// Returns the named cases, each once, or all if none is named. Throws InputError for an unknown name.
std::vector<const StabilityCase*> chosen_cases(const std::vector<std::string>& names) {
    const std::vector<const StabilityCase*> all = stability_cases();
    if (names.empty()) return all;
    std::vector<const StabilityCase*> chosen;
    for (const StabilityCase* one : all)
        if (std::find(names.begin(), names.end(), one->name) != names.end()) chosen.push_back(one);
    for (const std::string& name : names)
        if (std::none_of(all.begin(), all.end(), [&](const auto* one) { return one->name == name; }))
            throw common::InputError(fmt::format("CASE: there is no case '{}'; --list names them", name));
    return chosen;
}

/// The finished cases, in a file that is complete at any time.
class StabilityTable {
  public:
    StabilityTable(const fs::path& folder, bool full, int threads) : folder_(folder) {
        Json context = provenance();
        context["form"] = full ? "full" : "short";
        context["threads"] = threads;
        const EarlierRows earlier = read_earlier_rows(folder / "stability.json", context);
        document_ = {{"context", context}, {"rows", Json::array()}};
        if (earlier.found && earlier.same_context) document_["rows"] = earlier.document["rows"];
        if (earlier.found && !earlier.same_context)
            common::say(fmt::format("stability: {} is of another build, machine or form and is written anew",
                                    (folder / "stability.json").string()));
    }

    /// Adds a row, replacing an earlier one of the same case.
    void add(const Json& row) {
        const auto name_of = [](const Json& any) { return any["name"].get<std::string>(); };
        Json rows = Json::array();
        for (const StabilityCase* one : stability_cases()) {
            if (one->name == name_of(row)) rows.push_back(row);
            for (const Json& other : document_["rows"])
                if (name_of(other) == one->name && one->name != name_of(row)) rows.push_back(other);
        }
        document_["rows"] = rows;
        write_text(folder_ / "stability.json", document_.dump(1) + "\n");
        write_text(folder_ / "stability.md", cases_as_markdown(document_));
    }

    [[nodiscard]] const Json& rows() const { return document_["rows"]; }

  private:
    fs::path folder_;
    Json document_;
};

void draw_picture(const StabilityCase& one, const fs::path& folder) {
    if (!one.picture) return;
    if (const std::optional<common::Image> image = one.picture()) {
        prepare_output_folder("--out", folder / "images");
        common::write_png(folder / "images" / (one.name + ".png"), *image,
                          common::middle_grey_exposure(*image));
    }
}

void list_cases() {
    for (const StabilityCase* one : stability_cases())
        common::print_result(fmt::format("{:<22} {}\n", one->name, one->purpose));
}

void run(const StabilityOptions& options) {
    if (options.list) return list_cases();
    const std::vector<const StabilityCase*> chosen = chosen_cases(options.names);
    RunOptions run_options;
    run_options.threads = options.threads;
    common::ThreadPool pool(run_options.thread_count());
    const fs::path folder = options.out;
    check_results("--out", folder, {"stability.json", {"stability.md"}, {"charts", "images"}}, {});
    prepare_output_folder("--out", folder);
    const common::OutputLock lock("--out", folder / "stability.json");
    StabilityTable table(folder, !options.quick, pool.threads());

    const std::size_t seeds = CaseRun(!options.quick).seeds();
    common::Progress progress("stability", "seeds", chosen.size() * seeds);
    std::uint64_t done = 0;
    std::size_t finished = 0, failed = 0;
    const CaseRun case_run(!options.quick, {}, [&] {
        if (common::interrupted())
            throw Interrupted(fmt::format("stability stopped: {} finished cases are in {}", finished,
                                          (folder / "stability.json").string()));
        progress.show(done++);
    });
    for (const StabilityCase* one : chosen) {
        const common::Stopwatch stopwatch;
        const std::vector<StabilityCurve> curves = pool.run([&] { return one->run(case_run); });
        table.add(case_as_json(*one, curves, case_run.full(), seeds, stopwatch.seconds()));
        pool.run([&] { draw_picture(*one, folder); });
        done = ++finished * seeds;
        failed += !passes(curves, stability_cases().size());
    }
    common::print_result(
        fmt::format("{}\n{}\n", cases_as_text(table.rows()), (folder / "stability.md").string()));
    if (!write_report("stability", folder))
        common::say("stability: the charts could not be drawn; the table is complete");
    if (failed > 0) throw BoundExceeded(fmt::format("stability: {} cases are not as predicted", failed));
}

const RegisteredCommand registered(
    12, {.name = "stability",
         .purpose = "Hold both methods to theory where methods fail, in small scenes of its own",
         .add_to = [](Command& command) -> std::function<void()> {
             const auto options = std::make_shared<StabilityOptions>();
             command.option("CASE", options->names, "Cases; all where none is named");
             command.flag("--list", options->list, "Name the cases");
             command.flag("--short", options->quick, "The short form that ./check runs");
             command.option("--out", options->out,
                            "Folder for stability.json, stability.md, charts and images");
             add_threads_option(command, options->threads);
             return [options] { run(*options); };
         }});

}  // namespace

}  // namespace bench::stability
