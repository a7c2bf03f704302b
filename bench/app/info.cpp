// shlmbench info: describes a scene and what the methods can do with it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/contenders/contender.h"
#include "bench/contenders/memory_need.h"
#include "bench/contenders/warnings.h"
#include "bench/setup/command.h"
#include "common/core/input_error.h"
#include "common/core/standard_streams.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
    std::string file;
    SceneOptions scene;
    TexelOptions texels;
    bool json = false;
};

Json lightmap_facts(PreparedScene& prepared) {
    double area = 0, without = 0, overlapping = 0;
    std::array<std::size_t, 2> sets = {0, 0};
    for (std::size_t i = 0; i < prepared.lightmap_uv().size(); ++i) {
        const shlm::LightmapUv& uv = prepared.lightmap_uv()[i];
        area += uv.area;
        overlapping += uv.overlapping_area;
        if (uv.texcoord_set < 0)
            without += uv.area;
        else
            ++sets[uv.texcoord_set];
    }
    return {{"instances_by_texcoord_0", sets[0]},
            {"instances_by_texcoord_1", sets[1]},
            {"area", area},
            {"area_without", without},
            {"area_overlapping", overlapping},
            {"usable", sets[0] + sets[1] > 0}};
}

/// Returns the facts about texels; empty where no surface can have any.
Json texel_facts(PreparedScene& prepared) {
    const shlm::TexelPlacement placement = prepared.settings().texels.placement;
    std::size_t by_uv = 0, by_face = 0;
    for (const shlm::LightmapUv& uv : prepared.lightmap_uv()) {
        by_uv += shlm::placed_by_uv(uv, placement);
        by_face += shlm::placed_by_face(uv, placement);
    }
    if (by_uv + by_face == 0) return nullptr;

    const shlm::PreparedTexels& texels = prepared.texels();
    std::size_t covered = 0;
    double area = 0;
    for (const shlm::TexelGeometry& texel : texels.geometry) {
        covered += texel.area > 0;
        area += texel.area;
    }
    return {{"instances_by_uv", by_uv},
            {"instances_by_face", by_face},
            {"charts", texels.layout.regions().size()},
            {"total", texels.layout.texel_count()},
            {"covered", covered},
            {"mean_width", covered == 0 ? 0.0 : std::sqrt(area / static_cast<double>(covered))}};
}

/// Returns the problems of the lights; empty for a scene without light, which is acceptable here.
std::vector<std::string> trouble_with_light(const common::RayScene& rays) {
    try {
        return light_trouble(common::PhotonSource(rays));
    } catch (const common::InputError&) {
        return {};
    }
}

Json facts(const LoadedScene& loaded, PreparedScene& prepared) {
    const common::Scene& scene = loaded.scene;
    std::size_t emitting = 0;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) emitting += scene.material_of(t).emits();
    double area = 0;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) area += common::triangle_area(scene, t);
    std::array<std::size_t, 4> kinds = {0, 0, 0, 0};
    for (const common::Material& material : scene.material) ++kinds[static_cast<std::size_t>(material.kind)];
    std::vector<std::string> warnings = scene_warnings(loaded);
    const std::vector<std::string> light = trouble_with_light(loaded.rays);
    warnings.insert(warnings.end(), light.begin(), light.end());
    warnings.insert(warnings.end(), prepared.lightmap_trouble().begin(), prepared.lightmap_trouble().end());
    const Imath::V3d low = scene.origin + Imath::V3d(scene.bounds.min),
                     high = scene.origin + Imath::V3d(scene.bounds.max),
                     eye = scene.origin + Imath::V3d(loaded.camera.eye);
    return {
        {"scene", loaded.name},
        {"file", scene.source},
        {"triangles", scene.triangle.size()},
        {"instances", scene.instance.size()},
        {"area", area},
        {"origin", {scene.origin.x, scene.origin.y, scene.origin.z}},
        {"bounds", {{low.x, low.y, low.z}, {high.x, high.y, high.z}}},
        {"materials",
         {{"diffuse", kinds[0]}, {"mirror", kinds[1]}, {"dielectric", kinds[2]}, {"thin_sheet", kinds[3]}}},
        {"textures", scene.texture.size()},
        {"lights",
         {{"emitting_triangles", emitting},
          {"point", scene.point_light.size()},
          {"spot", scene.spot_light.size()},
          {"directional", scene.directional_light.size()},
          {"sky", scene.sky.has_value()}}},
        {"cameras", scene.camera.size()},
        {"camera",
         {{"name", loaded.camera.name},
          {"eye", {eye.x, eye.y, eye.z}},
          {"forward", {loaded.camera.forward.x, loaded.camera.forward.y, loaded.camera.forward.z}}}},
        {"lightmap_uv", lightmap_facts(prepared)},
        {"texels", texel_facts(prepared)},
        {"warnings", warnings}};
}

void run(const InfoOptions& options) {
    ContenderSettings settings;
    settings.texels = options.texels.choice();
    const LoadedScene loaded(options.file, options.scene);
    PreparedScene prepared(loaded, settings);
    require_memory(parse_contender("--texels", "shlm"), settings, 0, default_max_bytes());
    const Json all = facts(loaded, prepared);
    if (options.json) {
        common::print_result(
            fmt::format("{}\n", all.dump(2, ' ', false, Json::error_handler_t::replace)));  // odd file names
        return;
    }
    for (const auto& [key, value] : all.items())
        if (key != "warnings")
            common::print_result(
                fmt::format("{:<12} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump()));
    for (const auto& warning : all["warnings"])
        common::print_result(fmt::format("{:<12} {}\n", "warning", warning.get<std::string>()));
}

const RegisteredCommand registered(1, {.name = "info",
                                       .purpose = "Say what is in a scene and whether a light map fits on it",
                                       .add_to = [](Command& command) -> std::function<void()> {
                                           const auto options = std::make_shared<InfoOptions>();
                                           command.option("SCENE", options->file,
                                                          "glTF 2.0 file, .gltf or .glb", Need::required);
                                           options->scene.add_to(command);
                                           options->texels.add_to(command);
                                           command.flag("--json", options->json, "Print JSON");
                                           return [options] { run(*options); };
                                       }});

}  // namespace

}  // namespace bench
