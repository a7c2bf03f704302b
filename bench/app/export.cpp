// shlmbench export: a light map for other programs, and a page that lights the scene with it.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/contenders/adaptive_map.h"
#include "bench/contenders/contender_options.h"
#include "bench/contenders/light_map.h"
#include "bench/contenders/memory_need.h"
#include "bench/contenders/reference_scene.h"
#include "bench/contenders/trace_into.h"
#include "bench/contenders/warnings.h"
#include "bench/export/expanded_map.h"
#include "bench/export/exported_map.h"
#include "bench/export/light_atlas.h"
#include "bench/export/lightmap_files.h"
#include "bench/export/lit_glb.h"
#include "bench/export/viewer_page.h"
#include "bench/setup/command.h"
#include "bench/setup/ending.h"
#include "bench/setup/numbers.h"
#include "bench/setup/output_folder.h"
#include "bench/setup/provenance.h"
#include "bench/setup/run_options.h"
#include "bench/setup/trace_amount.h"
#include "common/core/fnv.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/output_file.h"
#include "common/core/progress.h"
#include "common/core/standard_streams.h"
#include "common/core/threads.h"
#include "common/difference/error_metrics.h"
#include "common/difference/flip.h"
#include "common/gltf/source_files.h"
#include "common/reference/reference_image.h"
#include "common/scene/fingerprint.h"
#include "common/view/visible_surfaces.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ExportOptions {
    std::string file, out, reference;
    TraceAmount amount;
    std::vector<std::string> names = {"shlm/L2/normalised/bilinear"};
    SceneOptions scene;
    MethodOptions methods;
    RunOptions run;
};

/// A request, checked.
struct ExportPlan {
    const ExportOptions& options;
    std::vector<Contender> maps;    ///< light maps, asked as a fragment program can
    std::vector<Contender> beside;  ///< photon maps: their answers at the camera's points
    ContenderSettings settings;
    common::TraceTarget target;
};

/// What a run has made.
struct FilledMaps {
    std::vector<ExportedMap> maps;
    common::TraceReport trace;
    AnsweredView view;
    std::optional<shlm::TexelLayout> layout;  ///< of the exported texels
};

const AdaptiveLightMap* adaptive(const Contender& contender) {
    return dynamic_cast<const AdaptiveLightMap*>(contender.light_map());
}

/// The same light map as it is exported: in halves, which an adaptive map has anyway.
Contender exported(const Contender& contender) {
    if (!std::holds_alternative<shlm::Bilinear>(contender.light_map()->setting().gather))
        throw common::InputError(
            fmt::format("--method: {} is no bilinear map; a fragment program has no search "
                        "for texels near in space",
                        contender.name));
    if (adaptive(contender)) return contender;
    const auto* uniform = static_cast<const UniformLightMap*>(contender.light_map());
    const auto technique = std::make_shared<UniformLightMap>(uniform->setting(), uniform->least_hits(), true);
    return {technique->name(), technique};
}

bool same_texels(const Contender& a, const Contender& b, const ContenderSettings& settings) {
    const TexelChoice x = a.light_map()->texel_choice(settings), y = b.light_map()->texel_choice(settings);
    return x.count == y.count && x.placement == y.placement;
}

ExportPlan make_plan(const ExportOptions& options) {
    ExportPlan plan{options, {}, {}, options.methods.settings(), options.amount.target()};
    for (const Contender& contender : parse_contenders("--method", parse_list("--method", options.names))) {
        if (contender.light_map())
            plan.maps.push_back(exported(contender));
        else
            plan.beside.push_back(contender);
    }
    if (plan.maps.empty())
        throw common::InputError("--method: at least one light map, shlm/..., is exported");
    for (const Contender& map : plan.maps)
        if (!same_texels(map, plan.maps.front(), plan.settings))
            throw common::InputError("--method: light maps of one export have the same texels");
    if (plan.maps.size() > 1 && std::any_of(plan.maps.begin(), plan.maps.end(), adaptive))
        throw common::InputError("--method: an adaptive map has texels of its own, and is exported alone");
    if (options.amount.is_traced_already() && plan.maps.size() + plan.beside.size() > 1)
        throw common::InputError("--map: holds the sums of one method");
    std::vector<fs::path> inputs = common::source_files(options.file);
    for (const std::string& file : {options.amount.map, options.reference})
        if (!file.empty()) inputs.emplace_back(file);
    check_results("--out", options.out,
                  {"lightmap.json", {"lit.glb", "lightmap.exr", "lightmap.npy", "viewer.html"}, {}}, inputs);
    double needed = 0;
    for (const auto* group : {&plan.maps, &plan.beside})
        for (const Contender& contender : *group) {
            require_memory(contender, plan.settings, plan.target.hits, default_max_bytes());
            needed += static_cast<double>(needed_bytes(contender, plan.settings, plan.target.hits));
        }
    if (needed > static_cast<double>(default_max_bytes()))
        throw common::InputError("--method: all of these at once need more memory than is free");
    return plan;
}

void stop_if_interrupted() {
    if (common::interrupted()) throw Interrupted("export stopped: nothing is written");
}

/// What the camera sees, at the reference's pixels where there is one.
AnsweredView view_of(const ExportOptions& options, const LoadedScene& loaded) {
    AnsweredView view;
    view.width = 160;
    view.height = 90;
    if (options.reference.empty()) {
        view.pixel = common::visible_surfaces(loaded.rays, loaded.camera, view.width, view.height);
        return view;
    }
    const auto reference = common::reference::read_reference(options.reference);
    view.width = reference.width;
    view.height = reference.height;
    view.pixel = common::visible_surfaces(loaded.rays, loaded.camera, view.width, view.height);
    const std::vector<bool> elsewhere =
        pixels_elsewhere(view.pixel, reference, loaded.scene, options.file, options.reference);
    std::vector<common::Rgb> irradiance;
    for (std::size_t p = 0; p < view.pixel.size(); ++p) {
        if (elsewhere[p]) view.pixel[p].present = false;
        irradiance.push_back(elsewhere[p] ? common::Rgb(0, 0, 0) : reference.pixel[p].irradiance);
    }
    view.answers.emplace_back("reference", std::move(irradiance));
    return view;
}

std::vector<common::SurfacePoint> points_of(const AnsweredView& view) {
    std::vector<common::SurfacePoint> points;
    for (const common::VisibleSurface& seen : view.pixel)
        if (seen.present) points.push_back(seen.point);
    return points;
}

/// `found`: of points_of(view).
void add_answers(AnsweredView& view, const std::string& name, std::span<const common::Rgb> found) {
    std::vector<common::Rgb> of_pixels(view.pixel.size(), common::Rgb(0, 0, 0));
    std::size_t next = 0;
    for (std::size_t p = 0; p < view.pixel.size(); ++p)
        if (view.pixel[p].present) of_pixels[p] = found[next++];
    view.answers.emplace_back(name, std::move(of_pixels));
}

/// Takes over an adaptive map as texels, and asks these.
void take_expanded(const Contender& contender, const shlm::TexelLayout& layout, LightMapStore& store,
                   FilledMaps& made) {
    const shlm::AdaptiveMap map = adaptive(contender)->map_of(store, made.trace);
    ExpandedMap expanded = expand(map, layout, store);
    const std::vector<common::SurfacePoint> points = points_of(made.view);
    const std::vector<common::Rgb> of_texels = ask(*answers_of_texels(expanded), points);
    const double differs = common::difference(of_texels, ask(*answers_of(map), points)).relative_rms;
    add_answers(made.view, contender.name, of_texels);
    const Expansion expansion{map.bytes(), expanded.bytes(), differs};
    made.maps.push_back({contender, std::move(expanded.texels), expansion});
    made.layout = std::move(expanded.layout);
}

/// Of a light map's store that is filled: takes over what it keeps, and asks it.
void take_map(const Contender& contender, const shlm::TexelLayout& layout, LightMapStore& store,
              FilledMaps& made) {
    if (adaptive(contender)) {
        take_expanded(contender, layout, store, made);
    } else {
        const auto& uniform = static_cast<const UniformLightMap&>(*contender.light_map());
        made.maps.push_back({contender, uniform.texels(store, made.trace)});
        add_answers(made.view, contender.name,
                    ask(*uniform.finish(store, made.trace).answers, points_of(made.view)));
        made.layout = layout;
    }
    require_finite(made.maps.back());
    stop_if_interrupted();
}

/// Of the texels that all maps sum in.
const shlm::TexelLayout& layout_of(const ExportPlan& plan, PreparedScene& prepared) {
    return plan.maps.front().light_map()->texels_of(prepared).layout;
}

void trace_maps(const ExportPlan& plan, const LoadedScene& loaded, const common::PhotonSource& source,
                PreparedScene& prepared, FilledMaps& made) {
    std::vector<FilledStore> stores;
    for (const auto* group : {&plan.maps, &plan.beside})
        for (const Contender& contender : *group)
            stores.emplace_back(ContenderGroup{contender}, prepared, source);
    const common::TraceTarget& target = plan.target;
    common::Progress progress("tracing", target.hits ? "hits" : "photons",
                              target.hits ? target.hits : target.photons);
    made.trace = trace_into(
        std::span(stores),
        {loaded.rays, source, plan.options.run.seed, target, [&](const common::TraceReport& so_far) {
             progress.show(target.hits ? so_far.hits : so_far.fates.emitted);
             return !common::interrupted();
         }});
    stop_if_interrupted();
    for (std::size_t i = 0; i < plan.maps.size(); ++i)
        take_map(plan.maps[i], layout_of(plan, prepared), static_cast<LightMapStore&>(*stores[i].store),
                 made);
    for (std::size_t i = 0; i < plan.beside.size(); ++i) {
        const Contender& contender = plan.beside[i];
        const FinishedMap map = contender->finish(*stores[plan.maps.size() + i].store, made.trace);
        add_answers(made.view, contender.name, ask(*map.answers, points_of(made.view)));
        stop_if_interrupted();
    }
    for (const std::string& line : run_trouble(made.trace, stores.front().store->facts().rejected, source))
        print_warning(loaded, line);
}

/// From the sums that trace has written.
void read_map(const ExportPlan& plan, const common::PhotonSource& source, PreparedScene& prepared,
              FilledMaps& made) {
    const LightMapTechnique& light_map = *plan.maps.front().light_map();
    const shlm::MapIdentity identity = light_map.identity(prepared, source, plan.options.run.seed);
    const std::unique_ptr<LightMapStore> sums = light_map.make_sums(prepared, source);
    made.trace =
        sums->read(plan.options.amount.map, identity, shlm::TexelAtlas(light_map.texels_of(prepared).layout))
            .report();
    stop_if_interrupted();
    take_map(plan.maps.front(), layout_of(plan, prepared), *sums, made);
}

std::string hash_of(std::string_view bytes) {
    std::uint64_t hash = common::fnv_start;
    for (const char byte : bytes) hash = common::fnv_step(hash, static_cast<unsigned char>(byte));
    return fmt::format("{:016x}", hash);
}

/// Of all answers where there is a reference, which is the first.
void add_flip(AnsweredView& view) {
    if (view.answers.front().first != "reference") return;
    const std::vector<common::Rgb>& truth = view.answers.front().second;
    std::vector<common::Rgb> of_points;
    for (std::size_t p = 0; p < truth.size(); ++p)
        if (view.pixel[p].present) of_points.push_back(truth[p]);
    const common::Exposures exposures = common::exposures_for(of_points);
    for (const auto& [name, answers] : view.answers)
        if (name != "reference")
            view.flip.emplace_back(name,
                                   common::flip_map(answers, truth, view.width, view.height, exposures));
}

void find_places(AnsweredView& view, std::span<const LitPrimitive> primitives) {
    const PrimitivePoints points(primitives);
    for (const common::VisibleSurface& seen : view.pixel)
        view.place.push_back(seen.present ? points.find(seen.point) : std::nullopt);
}

Json summary(const ExportPlan& plan, const FilledMaps& made, const ExportedRun& run, const LightAtlas& atlas,
             const std::string& glb) {
    Json context = provenance();
    context["seed"] = run.seed;
    context["threads"] = plan.options.run.thread_count();
    context["settings"] = describe(plan.settings);
    Json maps = Json::array();
    for (const ExportedMap& map : made.maps) maps.push_back(description_of(map));
    return {{"context", std::move(context)},  {"scene", run.scene},
            {"fingerprint", run.fingerprint}, {"hits", run.hits},
            {"photons_emitted", run.photons}, {"atlas", description_of(atlas)},
            {"maps", std::move(maps)},        {"lit.glb", {{"bytes", glb.size()}, {"fnv1a", hash_of(glb)}}}};
}

void write(const ExportPlan& plan, FilledMaps& made, const LoadedScene& loaded) {
    const ExportedRun run{loaded.name, common::fingerprint(loaded.scene), plan.options.run.seed,
                          made.trace.hits, made.trace.fates.emitted};
    const LightAtlas atlas = make_light_atlas(*made.layout, made.maps.front().texels.face);
    const std::vector<LitPrimitive> primitives = lit_primitives(loaded.scene, *made.layout, atlas);
    find_places(made.view, primitives);
    add_flip(made.view);
    const std::string glb = lit_glb({loaded, atlas, primitives, made.maps, run});
    const Json all = summary(plan, made, run, atlas, glb);
    const std::string page = viewer_page(glb, all, made.view);
    stop_if_interrupted();
    const fs::path out = plan.options.out;
    prepare_output_folder("--out", out);
    write_text(out / "lightmap.json", all.dump(1) + "\n");  // first: whose the others are
    write_lightmap_exr(out / "lightmap.exr", made.maps.front(), atlas, run);
    write_lightmap_npy(out / "lightmap.npy", made.maps.front(), atlas);
    write_text(out / "lit.glb", glb);
    write_text(out / "viewer.html", page);
    for (const char* name : {"lit.glb", "lightmap.exr", "lightmap.npy", "lightmap.json", "viewer.html"})
        common::print_result(fmt::format("{}: {} bytes\n", (out / name).string(), fs::file_size(out / name)));
    if (const auto& expansion = made.maps.front().expansion)
        common::print_result(fmt::format("{}: {} bytes as blocks, {} as texels\n",
                                         made.maps.front().method.name, expansion->bytes_of_map,
                                         expansion->bytes_of_texels));
}

void run(const ExportOptions& options) {
    const ExportPlan plan = make_plan(options);
    common::ThreadPool pool(options.run.thread_count());
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        const common::PhotonSource source(loaded.rays);
        PreparedScene prepared(loaded, plan.settings);
        for (const Contender& map : plan.maps) (void)map->prepare(prepared);
        FilledMaps made;
        made.view = view_of(options, loaded);
        print_scene_warnings(loaded);
        print_light_warnings(loaded, source);
        print_lightmap_warnings(loaded, prepared);
        if (!options.amount.is_traced_already())
            trace_maps(plan, loaded, source, prepared, made);
        else
            read_map(plan, source, prepared, made);
        write(plan, made, loaded);
    });
}

const RegisteredCommand registered(
    14, {.name = "export",
         .purpose = "Write a light map for other programs, and a page that lights the scene with it",
         .add_to = [](Command& command) -> std::function<void()> {
             const auto options = std::make_shared<ExportOptions>();
             command.option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb", Need::required);
             command.option(
                 "--method", options->names,
                 "Light maps, shlm/BASIS/WEIGHT/bilinear, separated by commas, the first of which is the "
                 "light map "
                 "of other programs; or one adaptive map, such as shlm/a5; photon maps to compare with");
             options->amount.add_to(command);
             command.option("--reference", options->reference,
                            "Image of shlmbench reference: the page shows errors against it");
             command.option("--out", options->out,
                            "Folder for lit.glb, lightmap.exr, .npy and .json, viewer.html", Need::required);
             options->scene.add_to(command);
             options->methods.add_to(command);
             options->run.add_to(command);
             return [options] { run(*options); };
         }});

}  // namespace

}  // namespace bench
