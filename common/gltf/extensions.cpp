#include "common/gltf/extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Json = nlohmann::json;

enum class Treatment {
    read,      ///< drawn as the file says; the code that reads it warns of exceptions
    unseen,    ///< has no visible effect before something is played
    fallback,  ///< offers variants, of which the default is drawn
    not_drawn  ///< the material warns if it uses the extension (not_drawn.h)
};

struct Extension {
    std::string_view name;
    Treatment treatment;
};

/// All other extensions are not drawn: an error if the file requires them, else a warning.
constexpr std::array<Extension, 24> known = {{
    {"EXT_mesh_gpu_instancing", Treatment::read},
    {"KHR_lights_punctual", Treatment::read},
    {"KHR_materials_emissive_strength", Treatment::read},
    {"KHR_materials_ior", Treatment::read},
    {"KHR_materials_pbrSpecularGlossiness", Treatment::read},
    {"KHR_materials_transmission", Treatment::read},
    {"KHR_materials_unlit", Treatment::read},
    {"KHR_materials_volume", Treatment::read},
    {"KHR_mesh_quantization", Treatment::read},
    {"KHR_node_visibility", Treatment::read},
    {"KHR_texture_transform", Treatment::read},
    {"KHR_animation_pointer", Treatment::unseen},
    {"KHR_node_hoverability", Treatment::unseen},
    {"KHR_node_selectability", Treatment::unseen},
    {"KHR_xmp", Treatment::unseen},
    {"KHR_xmp_json_ld", Treatment::unseen},
    {"KHR_materials_variants", Treatment::fallback},
    {"KHR_materials_anisotropy", Treatment::not_drawn},
    {"KHR_materials_clearcoat", Treatment::not_drawn},
    {"KHR_materials_diffuse_transmission", Treatment::not_drawn},
    {"KHR_materials_dispersion", Treatment::not_drawn},
    {"KHR_materials_iridescence", Treatment::not_drawn},
    {"KHR_materials_sheen", Treatment::not_drawn},
    {"KHR_materials_specular", Treatment::not_drawn},
}};

const Extension* find_known(std::string_view name) {
    const auto* found =
        std::find_if(known.begin(), known.end(), [&](const Extension& each) { return each.name == name; });
    return found == known.end() ? nullptr : found;
}

void warn(const std::string& name, const std::string& place, Warnings& warnings) {
    const Extension* extension = find_known(name);
    if (extension == nullptr) {
        warnings.add(fmt::format("extension {} ignored", name), place);
    } else if (extension->treatment == Treatment::fallback) {
        warnings.add(fmt::format("extension {} ignored, its default is drawn", name), place);
    }
}

std::vector<std::string> extension_list(const Json& document, const char* key) {
    std::vector<std::string> names;
    if (!document.contains(key)) return names;
    const Json& list = document.at(key);
    if (!list.is_array()) throw InputError(fmt::format("{} is not a list of names", key));
    for (const Json& name : list) {
        if (!name.is_string()) throw InputError(fmt::format("{} is not a list of names", key));
        names.push_back(name.get<std::string>());
    }
    return names;
}

/// Warns of the extensions of `value` and of everything in it, except "extras", which can hold anything. Adds
/// their names to `used`.
void warn_about_used(const Json& value, const std::string& place, std::set<std::string>& used,
                     Warnings& warnings) {
    if (value.is_object() && value.contains("extensions") && value.at("extensions").is_object()) {
        for (const auto& [name, extension] : value.at("extensions").items()) {
            used.insert(name);
            warn(name, place.empty() ? "the file" : place, warnings);
        }
    }
    for (const auto& [key, element] : value.items()) {
        if (element.is_structured() && key != "extras")
            warn_about_used(element, place.empty() ? key : place + "/" + key, used, warnings);
    }
}

}  // namespace

void check_extensions(const Json& document, Warnings& warnings) {
    for (const std::string& name : extension_list(document, "extensionsRequired")) {
        const Extension* extension = find_known(name);
        if (extension == nullptr || extension->treatment == Treatment::not_drawn)
            throw InputError(fmt::format("requires the extension {}, which is not supported", name));
    }
    std::set<std::string> used;
    warn_about_used(document, "", used, warnings);
    for (const std::string& name : extension_list(document, "extensionsUsed")) {
        if (!used.contains(name)) warn(name, "extensionsUsed", warnings);
    }
}

}  // namespace common::gltf
