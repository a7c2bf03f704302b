// shlmbench render: renders a scene with one method.

#include <fmt/format.h>

#include <filesystem>

#include "bench/contenders/contender_options.h"
#include "bench/contenders/direct_light.h"
#include "bench/contenders/light_map.h"
#include "bench/contenders/memory_need.h"
#include "bench/contenders/picture.h"
#include "bench/contenders/warnings.h"
#include "bench/setup/command.h"
#include "bench/setup/emission_option.h"
#include "bench/setup/ending.h"
#include "bench/setup/image_output.h"
#include "bench/setup/provenance.h"
#include "bench/setup/run_options.h"
#include "bench/setup/trace_amount.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/progress.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"
#include "common/gltf/source_files.h"
#include "common/tracer/rejected_hits.h"

namespace bench {
namespace {

struct RenderOptions {
    std::string file, method, out;
    TraceAmount amount;
    SceneOptions scene;
    MethodOptions methods;
    DirectOptions direct;
    EmissionOption emission;
    RunOptions run;
    int width = 640, height = 360;
};

/// The checked options.
struct RenderPlan {
    const RenderOptions& options;
    Contender method;
    ContenderSettings settings;
    common::TraceTarget target;
    std::size_t max_bytes;  ///< for the method
};

struct Rendering {
    common::Image image;
    common::TraceReport trace;
    common::RejectedHits rejected;
};

/// Returns the memory that is left for the method beside the image.
std::size_t max_map_bytes(const RenderOptions& options) {
    constexpr std::size_t pixel_bytes = sizeof(common::VisibleSurface) + 16 * sizeof(float);
    const std::size_t free = default_max_bytes();
    return free - std::min(free, pixel_bytes * options.width * options.height);
}

/// Returns the estimated hits of the whole run: with --photons they are known only after some are traced.
std::uint64_t expected_hits(const common::TraceReport& so_far, const common::TraceTarget& target) {
    if (target.hits > 0) return target.hits;
    return static_cast<std::uint64_t>(static_cast<double>(so_far.hits) * static_cast<double>(target.photons) /
                                      static_cast<double>(so_far.fates.emitted));
}

void stop_if_interrupted() {
    if (common::interrupted()) throw Interrupted("render stopped: no image is written");
}

Rendering trace_and_gather(const RenderPlan& plan, const LoadedScene& loaded,
                           const common::PhotonSource& source, PreparedScene& prepared) {
    const RenderOptions& options = plan.options;
    const common::TraceTarget& target = plan.target;
    const auto pixels = common::visible_surfaces(loaded.rays, loaded.camera, options.width, options.height);
    const std::unique_ptr<Store> store = plan.method->make_store(prepared, source);
    common::Progress progress("tracing", target.hits ? "hits" : "photons",
                              target.hits ? target.hits : target.photons);
    const auto trace =
        trace_into(*store, {loaded.rays,
                            source,
                            options.run.seed,
                            target,
                            [&](const common::TraceReport& so_far) {
                                progress.show(target.hits ? so_far.hits : so_far.fates.emitted);
                                require_memory(plan.method, plan.settings, expected_hits(so_far, target),
                                               plan.max_bytes);
                                return !common::interrupted();
                            },
                            {},
                            recorded_hits(plan.settings.direct)});
    stop_if_interrupted();
    const common::RejectedHits rejected = store->facts().rejected;
    const FinishedMap map = finish_with_direct(plan.method, *store, trace, prepared, options.run.seed);
    stop_if_interrupted();
    return {render_map(*map.answers, pixels, options.width, options.height), trace, rejected};
}

/// Renders from the sums that trace has written.
Rendering gather_from_file(const RenderPlan& plan, const LoadedScene& loaded,
                           const common::PhotonSource& source, PreparedScene& prepared) {
    const RenderOptions& options = plan.options;
    const LightMapTechnique* light_map = plan.method.light_map();
    if (!light_map) throw common::InputError("--map: only a light map, --method shlm/..., comes from a file");
    const shlm::PreparedTexels& texels = light_map->texels_of(prepared);
    const shlm::MapIdentity identity = light_map->identity(prepared, source, options.run.seed);
    const auto pixels = common::visible_surfaces(loaded.rays, loaded.camera, options.width, options.height);
    const std::unique_ptr<LightMapStore> sums = light_map->make_sums(prepared, source);
    const common::TraceReport trace =
        sums->read(options.amount.map, identity, shlm::TexelAtlas(texels.layout)).report();
    stop_if_interrupted();
    const FinishedMap map = light_map->finish(*sums, trace);
    return {render_map(*map.answers, pixels, options.width, options.height), trace, sums->facts().rejected};
}

/// Warns the reader if most visible surfaces have no light at all. Perhaps no hits fall on what the picture
/// shows, as on a terrace in a wide plain.
void warn_about_unlit_picture(const LoadedScene& loaded, const common::Image& image) {
    std::size_t surfaces = 0, unlit = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        if (image.at(p, 3) == 0) continue;
        ++surfaces;
        unlit += image.at(p, 4) == 0 && image.at(p, 5) == 0 && image.at(p, 6) == 0;
    }
    if (2 * unlit > surfaces)
        print_warning(loaded,
                      fmt::format("{:.0f} % of the surface in the picture has no light at all: no hit "
                                  "is near it; it lies in the dark, or more hits are needed",
                                  100 * static_cast<double>(unlit) / static_cast<double>(surfaces)));
}

std::vector<std::filesystem::path> inputs_of(const RenderOptions& options) {
    std::vector<std::filesystem::path> inputs = common::source_files(options.file);
    if (options.amount.is_traced_already()) inputs.emplace_back(options.amount.map);
    return inputs;
}

RenderPlan make_plan(const RenderOptions& options) {
    RenderPlan plan{options, parse_contender("--method", options.method), options.methods.settings(),
                    options.amount.target(), max_map_bytes(options)};
    plan.settings.direct = options.direct.setting();
    plan.settings.emission = options.emission.sequence();
    if (plan.settings.direct.is_traced && options.amount.is_traced_already())
        throw common::InputError("--direct: the sums of --map hold direct light already");
    if (plan.settings.emission != common::EmissionSequence::random && options.amount.is_traced_already())
        throw common::InputError("--emission: the photons of --map are traced already");
    check_image_output(options.out, options.width, options.height, [&] { return inputs_of(options); });
    check_replaces_a_rendered_image(options.out);
    require_memory(plan.method, plan.settings, plan.target.hits, plan.max_bytes);
    return plan;
}

void run(const RenderOptions& options) {
    const RenderPlan plan = make_plan(options);
    common::ThreadPool pool(options.run.thread_count());
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        const common::PhotonSource source(loaded.rays, plan.settings.emission);
        PreparedScene prepared(loaded, plan.settings);
        (void)plan.method->prepare(prepared);  // errors are reported before warnings
        const auto print_warnings = [&] {
            print_scene_warnings(loaded);
            print_light_warnings(loaded, source);
            if (plan.method.light_map()) print_lightmap_warnings(loaded, prepared);
        };
        // A file of sums may not fit this scene, so its warnings come last; tracing takes long, so they come
        // first.
        const bool from_file = options.amount.is_traced_already();
        if (!from_file) print_warnings();
        const Rendering made = from_file ? gather_from_file(plan, loaded, source, prepared)
                                         : trace_and_gather(plan, loaded, source, prepared);
        if (from_file) print_warnings();
        stop_if_interrupted();
        for (const std::string& line : run_trouble(made.trace, made.rejected, source))
            print_warning(loaded, line);
        warn_about_unlit_picture(loaded, made.image);

        common::ImageNotes notes = provenance_notes();
        notes["shlmbench:scene"] = loaded.name;
        notes["shlmbench:method"] = plan.method.name;
        notes["shlmbench:settings"] = describe(prepared.settings());
        notes["shlmbench:seed"] = std::to_string(options.run.seed);
        notes["shlmbench:hits"] = std::to_string(made.trace.hits);
        notes["shlmbench:photons_emitted"] = std::to_string(made.trace.fates.emitted);
        notes["shlmbench:hits_rejected"] = std::to_string(made.rejected.total());
        common::write_exr(options.out, made.image, notes);
        common::write_png(picture_of(options.out), made.image, common::middle_grey_exposure(made.image));
        common::print_result(fmt::format("{}: {} hits of {} photons, {} of them rejected\n", options.out,
                                         made.trace.hits, made.trace.fates.emitted, made.rejected.total()));
    });
}

const RegisteredCommand registered(
    2, {.name = "render",
        .purpose = "Draw a scene with one method: half-float EXR and tone-mapped PNG",
        .add_to = [](Command& command) -> std::function<void()> {
            const auto options = std::make_shared<RenderOptions>();
            command.option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb", Need::required);
            command.option("--method", options->method,
                           "photonmap, shlm, or a full name such as shlm/L2/radiance/knn4", Need::required);
            options->amount.add_to(command);
            command.option("--out", options->out, "Image to write, .exr; the PNG goes beside it",
                           Need::required);
            command.whole_number("--width", options->width, "Pixels");
            command.whole_number("--height", options->height, "Pixels");
            options->scene.add_to(command);
            options->methods.add_to(command);
            options->direct.add_to(command);
            options->emission.add_to(command);
            options->run.add_to(command);
            return [options] { run(*options); };
        }});

}  // namespace

}  // namespace bench
