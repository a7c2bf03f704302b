// shlmbench bases: the error of a texel's basis at tilted normals, without a scene and without noise.
#include <fmt/format.h>

#include <filesystem>

#include "bench/experiments/bases/bases_table.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/numbers.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/report.h"
#include "bench/setup/run_options.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/output_lock.h"
#include "common/core/progress.h"
#include "common/core/standard_streams.h"

namespace bench::bases {
namespace {

constexpr std::uint64_t most_environments = 100'000;

struct BasesOptions {
    std::uint64_t environments = 240;
    std::uint64_t seed = 1;
    std::string out;
};

/// Measures the bases in all kinds of light. Throws Interrupted.
std::vector<BasisFigures> measure(std::size_t count, std::uint64_t seed) {
    std::uint64_t total = 0, done = 0;
    for (const LightKind kind : light_kinds) total += environment_count(kind, count);
    common::Progress progress("bases", "environments", total);
    const auto go_on = [&] {
        progress.show(done++);
        return !common::interrupted();
    };
    std::vector<BasisFigures> all;
    for (const LightKind kind : light_kinds) {
        const auto figures = measure_bases(all_bases(), kind, count, seed, go_on);
        if (!figures)
            throw Interrupted("bases stopped: nothing is written, a part of the environments is no table");
        all.insert(all.end(), figures->begin(), figures->end());
    }
    return all;
}

void run(const BasesOptions& options) {
    if (options.environments < 1 || options.environments > most_environments)
        throw common::InputError(fmt::format("--environments: from 1 to {}", most_environments));
    const std::filesystem::path folder = options.out;
    check_results("--out", folder, {"bases.json", {"bases.md"}, {"charts"}}, {});
    prepare_output_folder("--out", folder);
    const common::OutputLock lock("--out", folder / "bases.json");
    const std::vector<BasisFigures> figures =
        measure(static_cast<std::size_t>(options.environments), options.seed);
    write_text(folder / "bases.json",
               bases_as_json(figures, measure_tilt_curve(), options.seed).dump(1) + "\n");
    write_text(folder / "bases.md", bases_as_markdown(figures, options.seed));
    if (!write_report("bases", folder))
        common::say("bases: the charts could not be drawn; the table is complete");
    common::print_result(fmt::format("{}\n{}\n", bases_as_text(figures), (folder / "bases.json").string()));
}

const RegisteredCommand registered(
    9, {.name = "bases",
        .purpose = "Say what a texel's basis loses at tilted normals, without a scene",
        .add_to = [](Command& command) -> std::function<void()> {
            const auto options = std::make_shared<BasesOptions>();
            command.whole_number("--environments", options->environments, "Random environments of each kind");
            add_seed_option(command, options->seed);
            command.option("--out", options->out, "Folder for bases.json, bases.md and charts",
                           Need::required);
            return [options] { run(*options); };
        }});

}  // namespace

}  // namespace bench::bases
