#include "bench/app/reference.h"

#include <fmt/format.h>

#include <chrono>

#include "bench/app/image_output.h"
#include "bench/app/provenance.h"
#include "bench/app/reference_target.h"
#include "bench/app/run_options.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"
#include "common/core/threads.h"
#include "common/reference/continuation.h"
#include "common/reference/paths_not_found.h"
#include "common/reference/strata.h"
#include "common/scene/fingerprint.h"

namespace bench {
namespace {

namespace reference = common::reference;
using common::InputError;
using reference::samples_per_pass;

struct ReferenceOptions {
    std::string file, out, spp, until;
    SceneOptions scene;
    RunOptions run;
    int width = 128, height = 72;
};

/// What is the same for all passes of a run.
struct Run {
    const ReferenceOptions& options;
    const LoadedScene& loaded;
    std::vector<common::VisibleSurface> pixels;
    reference::Lights lights;
    reference::ReferenceIdentity identity;

    Run(const ReferenceOptions& o, const LoadedScene& l)
        : options(o),
          loaded(l),
          pixels(common::visible_surfaces(l.rays, l.camera, o.width, o.height)),
          lights(l.scene),
          identity{common::fingerprint(l.scene), o.run.seed, o.width, o.height,
                   reference::describe(l.camera)} {}
};

void print_warnings(const LoadedScene& loaded) {
    for (const std::string& line : loaded.scene.warnings)
        fmt::print(stderr, "{}: warning: {}\n", loaded.name, line);
    if (const std::string lost = reference::paths_not_found(loaded.scene); !lost.empty())
        fmt::print(stderr, "{}: warning: not in the reference: {}\n", loaded.name, lost);
}

void require_light(const common::Scene& scene, const reference::Lights& lights) {
    if (lights.light().empty() && !scene.sky)
        throw InputError(scene.source +
                         ": no light in the scene; add one with --sky R,G,B or --sun X,Y,Z,R,G,B");
}

void write(const Run& run, const reference::ReferenceSums& sums) {
    common::ImageNotes notes = provenance_notes();
    notes.merge(reference::continuation_notes(run.identity, sums));
    const std::string lost = reference::paths_not_found(run.loaded.scene);
    notes["shlmbench:scene"] = run.loaded.name;
    notes["shlmbench:method"] = "reference";
    notes["shlmbench:samples_per_pixel"] = std::to_string(sums.passes * samples_per_pass);
    notes["shlmbench:relative_error"] = fmt::format("{:.6g}", reference::relative_error(run.pixels, sums));
    notes["shlmbench:paths_not_found"] = lost.empty() ? "none" : lost;
    const common::Image image = reference::to_image(run.pixels, run.options.width, run.options.height, sums);
    common::write_exr(run.options.out, image, notes, common::Precision::single);
    common::write_png(std::filesystem::path(run.options.out).replace_extension(".png"), image,
                      common::middle_grey_exposure(image));
}

/// Adds passes until the target is reached or the user stops it, and saves now and then. Returns whether it
/// was reached.
bool sample(const Run& run, const ReferenceTarget& target, reference::ReferenceSums& sums) {
    using Clock = std::chrono::steady_clock;
    constexpr auto between_saves = std::chrono::minutes(1);
    constexpr std::uint64_t fewest_passes = 2;  // that have a variance
    const auto paths = [&](std::uint64_t passes) { return passes * samples_per_pass * run.pixels.size(); };
    const std::uint64_t passes_before = sums.passes;
    common::Progress progress("reference", "paths", 1);
    auto saved = Clock::now();
    while (true) {
        const double error = reference::relative_error(run.pixels, sums);
        if (target.reached(sums.passes, error)) return true;
        progress.set_total(paths(target.expected_passes(sums.passes, error) - passes_before));
        const auto keep_going = [&](std::size_t pixels_done) {
            progress.show(paths(sums.passes - passes_before) + pixels_done * samples_per_pass);
            return !common::interrupted();
        };
        if (!reference::add_pass(run.loaded.rays, run.lights, run.pixels, run.options.run.seed, sums,
                                 keep_going))
            return false;
        if (sums.passes >= fewest_passes && Clock::now() - saved > between_saves) {
            write(run, sums);
            saved = Clock::now();
        }
    }
}

std::string state_of(const Run& run, const reference::ReferenceSums& sums) {
    return fmt::format("{}: {} samples per pixel, relative error {:.3g} %", run.options.out,
                       sums.passes * samples_per_pass, 100 * reference::relative_error(run.pixels, sums));
}

void run(const ReferenceOptions& options) {
    const ReferenceTarget target = reference_target(options.spp, options.until);
    check_image_output(options.out, options.width, options.height);
    common::ThreadPool pool(options.run.thread_count());
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        const Run run(options, loaded);
        require_light(loaded.scene, run.lights);
        std::optional<reference::ReferenceSums> before =
            reference::sums_to_go_on_from(options.out, run.identity);
        print_warnings(loaded);
        if (before) fmt::print(stderr, "going on from {}\n", state_of(run, *before));

        reference::ReferenceSums sums = before.value_or(reference::ReferenceSums(run.pixels.size()));
        const std::uint64_t passes_before = sums.passes;
        const bool reached = sample(run, target, sums);
        if (sums.passes > passes_before && sums.passes >= 2) write(run, sums);
        if (!reached)
            throw Interrupted(sums.passes < 2 ? "reference stopped: no image is written"
                                              : "reference stopped: " + state_of(run, sums));
        fmt::print("{}\n", state_of(run, sums));
    });
}

}  // namespace

void add_reference_command(CLI::App& app) {
    const auto options = std::make_shared<ReferenceOptions>();
    CLI::App* command = app.add_subcommand(
        "reference",
        "Path trace what the methods estimate: irradiance with its variance, single-float EXR and PNG");
    command->add_option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb")->required();
    command
        ->add_option(
            "--out", options->out,
            "Image to write, .exr; the PNG goes beside it. A reference of the same run is gone on from")
        ->required();
    command->add_option("--spp", options->spp,
                        "Samples per pixel, rounded up to whole passes of 64; 1024 if nothing is said");
    command->add_option("--until", options->until,
                        "Sample until the relative error is at most this, e.g. 0.1%");
    command->add_option("--width", options->width, "Pixels")->capture_default_str();
    command->add_option("--height", options->height, "Pixels")->capture_default_str();
    options->scene.add_to(*command);
    options->run.add_to(*command);
    command->callback([options] { run(*options); });
}

}  // namespace bench
