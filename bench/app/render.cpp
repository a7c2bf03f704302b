#include "bench/app/render.h"

#include <fmt/format.h>

#include <filesystem>

#include "bench/app/method_options.h"
#include "bench/app/provenance.h"
#include "bench/app/run_options.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"
#include "common/core/threads.h"
#include "common/image/render.h"
#include "common/tracer/trace_photons.h"

namespace bench {
namespace {

struct RenderOptions {
    std::string file, method, out;
    SceneOptions scene;
    MethodOptions methods;
    RunOptions run;
    std::string hits, photons;
    int width = 640, height = 360;
};

struct Rendering {
    common::Image image;
    common::TraceReport trace;
    common::RejectedHits rejected;
};

common::TraceTarget target_of(const RenderOptions& options) {
    if (options.hits.empty() == options.photons.empty())
        throw common::InputError("one of --hits and --photons says how much to trace");
    if (!options.hits.empty()) return {.hits = parse_count("--hits", options.hits)};
    return {.photons = parse_count("--photons", options.photons)};
}

void check_output(const RenderOptions& options) {
    const std::filesystem::path out(options.out);
    if (out.extension() != ".exr") throw common::InputError("--out: the image is an .exr file");
    const auto folder = out.has_parent_path() ? out.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder))
        throw common::InputError(fmt::format("--out: there is no folder {}", folder.string()));
    if (options.width < 1 || options.height < 1 || options.width > 16384 || options.height > 16384)
        throw common::InputError("--width and --height: from 1 to 16384");
}

Rendering trace_and_gather(const RenderOptions& options, const LoadedScene& loaded, PreparedMethods& prepared,
                           const common::TraceTarget& target) {
    const common::PhotonSource source(loaded.scene);
    const auto pixels = common::visible_surfaces(loaded.rays, loaded.camera, options.width, options.height);
    return with_sink(options.method, prepared, [&](auto sink) {
        common::Progress progress("tracing", target.hits ? "hits" : "photons",
                                  target.hits ? target.hits : target.photons);
        const auto trace = common::trace_photons(
            loaded.rays, source, options.run.seed, target, sink, [&](const common::TraceReport& so_far) {
                progress.show(target.hits ? so_far.hits : so_far.fates.emitted);
                return !common::interrupted();
            });
        const common::RejectedHits rejected = sink.rejected();
        const auto map = common::finish_map(std::move(sink), trace);
        return Rendering{common::render(pixels, options.width, options.height, map), trace, rejected};
    });
}

void run(RenderOptions options) {
    options.method = full_method_name(options.method);
    const common::TraceTarget target = target_of(options);
    check_output(options);
    const MethodSettings settings = options.methods.settings();
    common::ThreadPool pool(options.run.thread_count());
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        PreparedMethods prepared(loaded, settings);
        print_warnings(loaded, prepared, options.method == "shlm");
        const Rendering made = trace_and_gather(options, loaded, prepared, target);
        if (made.trace.interrupted) throw Interrupted("render stopped: no image is written");

        common::ImageNotes notes = provenance_notes();
        notes["shlmbench:scene"] = loaded.name;
        notes["shlmbench:method"] = options.method;
        notes["shlmbench:settings"] = describe(prepared.settings());
        notes["shlmbench:seed"] = std::to_string(options.run.seed);
        notes["shlmbench:hits"] = std::to_string(made.trace.hits);
        notes["shlmbench:photons_emitted"] = std::to_string(made.trace.fates.emitted);
        notes["shlmbench:hits_rejected"] = std::to_string(made.rejected.total());
        common::write_exr(options.out, made.image, notes);
        common::write_png(std::filesystem::path(options.out).replace_extension(".png"), made.image,
                          common::middle_grey_exposure(made.image));
        fmt::print("{}: {} hits of {} photons, {} rejected\n", options.out, made.trace.hits,
                   made.trace.fates.emitted, made.rejected.total());
    });
}

}  // namespace

void add_render_command(CLI::App& app) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        app.add_subcommand("render", "Draw a scene with one method: half-float EXR and tone-mapped PNG");
    command->add_option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb")->required();
    command->add_option("--method", options->method, "photonmap/flann, photonmap/flann-incremental or shlm")
        ->required();
    command->add_option("--hits", options->hits, "Trace until at least this many hits are stored, e.g. 1e6");
    command->add_option("--photons", options->photons, "Trace this many photons, rounded up to whole blocks");
    command->add_option("--out", options->out, "Image to write, .exr; the PNG goes beside it")->required();
    command->add_option("--width", options->width, "Pixels")->capture_default_str();
    command->add_option("--height", options->height, "Pixels")->capture_default_str();
    options->scene.add_to(*command);
    options->methods.add_to(*command);
    options->run.add_to(*command);
    command->callback([options] { run(*options); });
}

}  // namespace bench
