// shlmbench reference: path traces what the methods estimate, with its error.
#include <fmt/format.h>

#include <algorithm>

#include "bench/app/reference_run.h"
#include "bench/contenders/warnings.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/image_output.h"
#include "bench/setup/numbers.h"
#include "bench/setup/run_options.h"
#include "common/core/input_error.h"
#include "common/core/output_lock.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"
#include "common/gltf/source_files.h"
#include "common/reference/continuation.h"
#include "common/reference/paths_not_found.h"
#include "common/tracer/photon_source.h"

namespace bench {
namespace {

namespace reference = common::reference;
using common::InputError;

struct ReferenceOptions {
    std::string file, out, spp, until;
    SceneOptions scene;
    RunOptions run;
    int width = 128, height = 72;
};

/// Throws InputError where the camera sees nothing.
void require_something_to_measure(const LoadedScene& loaded, const ReferenceRun& run) {
    if (std::none_of(run.pixels.begin(), run.pixels.end(), [](const auto& pixel) { return pixel.present; }))
        throw InputError(loaded.scene.source +
                         ": the camera sees no diffuse surface; give another with --camera");
}

/// Returns the sums of the output file, if it exists.
std::optional<reference::ReferenceSums> earlier_sums(const ReferenceRun& run) {
    try {
        return reference::sums_to_go_on_from(run.out, run.identity);
    } catch (const common::InputError& e) {
        throw common::InputError(std::string("--out: ") + e.what());
    }
}

void run(const ReferenceOptions& options) {
    const ReferenceTarget target = reference_target(options.spp, options.until);
    check_image_output(options.out, options.width, options.height,
                       [&] { return common::source_files(options.file); });
    const common::OutputLock lock("--out", options.out);
    common::ThreadPool pool(options.run.thread_count());
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        const common::PhotonSource source(loaded.rays);  // refuses scenes without light
        const ReferenceRun run(loaded, source, options.run.seed, options.out, options.width, options.height);
        require_something_to_measure(loaded, run);
        std::optional<reference::ReferenceSums> before = earlier_sums(run);
        print_scene_warnings(loaded);
        if (const std::string endless = endless_light(source); !endless.empty())
            print_warning(loaded, endless);
        if (const std::string lost = reference::paths_not_found(loaded.scene); !lost.empty())
            print_warning(loaded, "not in the reference: " + lost);
        if (before) common::say(fmt::format("going on from {}", describe(run, *before)));

        reference::ReferenceSums sums = before.value_or(reference::ReferenceSums(run.pixels.size()));
        const std::uint64_t passes_before = sums.passes;
        const bool reached = sample(run, target, sums);
        if (sums.passes > passes_before && sums.passes >= fewest_passes) write(run, sums);
        if (!reached)
            throw Interrupted(sums.passes < fewest_passes ? "reference stopped: no image is written"
                                                          : "reference stopped: " + describe(run, sums));
        common::print_result(fmt::format("{}\n", describe(run, sums)));
    });
}

const RegisteredCommand registered(
    5, {.name = "reference",
        .purpose =
            "Path trace what the methods estimate: irradiance with its variance, single-float EXR and PNG",
        .add_to = [](Command& command) -> std::function<void()> {
            const auto options = std::make_shared<ReferenceOptions>();
            command.option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb", Need::required);
            command.option(
                "--out", options->out,
                "Image to write, .exr; the PNG goes beside it. A reference of the same run is gone on from",
                Need::required);
            command.option("--spp", options->spp,
                           "Samples per pixel, rounded up to whole passes of 64; 1024 if nothing is said");
            command.option("--until", options->until,
                           "Sample until the relative error is at most this, e.g. 0.1%");
            command.whole_number("--width", options->width, "Pixels");
            command.whole_number("--height", options->height, "Pixels");
            options->scene.add_to(command);
            options->run.add_to(command);
            return [options] { run(*options); };
        }});

}  // namespace

}  // namespace bench
