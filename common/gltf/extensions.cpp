#include "common/gltf/extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

/// Honoured, or warned about where they are used.
constexpr std::array<std::string_view, 16> known = {
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

/// These change how a surface looks, not where it is or what it emits: a scene is still that scene without
/// them.
constexpr std::array<std::string_view, 4> harmless = {
    "KHR_animation_pointer",
    "KHR_materials_variants",
    "KHR_xmp",
    "KHR_xmp_json_ld",
};

template <std::size_t size>
bool contains(const std::array<std::string_view, size>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> extension_list(const nlohmann::json& document, const char* key) {
    std::vector<std::string> names;
    if (!document.contains(key)) return names;
    const nlohmann::json& list = document.at(key);
    if (!list.is_array()) throw InputError(fmt::format("{} is not a list of names", key));
    for (const nlohmann::json& name : list) {
        if (!name.is_string()) throw InputError(fmt::format("{} is not a list of names", key));
        names.push_back(name.get<std::string>());
    }
    return names;
}

}  // namespace

void check_extensions(const nlohmann::json& document, Warnings& warnings) {
    for (const std::string& name : extension_list(document, "extensionsRequired")) {
        if (!contains(known, name) && !contains(harmless, name))
            throw InputError(fmt::format("requires the extension {}, which is not supported", name));
    }
    for (const std::string& name : extension_list(document, "extensionsUsed")) {
        if (!contains(known, name)) warnings.add("extensions ignored", name);
    }
}

}  // namespace common::gltf
