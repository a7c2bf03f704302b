// tinygltf ignores an optional property of the wrong type, truncates integers to 32 bits and does not check
// most indices and ranges. So all of that is checked here, from one table.
#include "common/gltf/check_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

enum class Type {
    object,
    flag,
    text,
    number,       ///< within the range of float
    numbers,      ///< Rule::length of them
    number_list,  ///< any number of them
    natural,      ///< integer >= 0
    natural_31_bit,
    index,    ///< into the list Rule::target
    indices,  ///< list of indices, or object whose values are indices
};

struct Rule {
    std::string property;
    Type type;
    const char* target = "";
    std::size_t length = 0;
};

struct ListRules {
    const char* list;
    std::vector<Rule> rules;
};

constexpr const char* light_list = "/extensions/KHR_lights_punctual/lights";

std::vector<Rule> primitive_rules() {
    return {{"/attributes", Type::indices, "/accessors"},
            {"/indices", Type::index, "/accessors"},
            {"/material", Type::index, "/materials"},
            {"/mode", Type::natural_31_bit}};
}

std::vector<Rule> material_rules() {
    std::vector<Rule> rules = {
        {"/name", Type::text},
        {"/alphaCutoff", Type::number},
        {"/alphaMode", Type::text},
        {"/doubleSided", Type::flag},
        {"/emissiveFactor", Type::numbers, "", 3},
        {"/normalTexture/scale", Type::number},
        {"/occlusionTexture/strength", Type::number},
        {"/pbrMetallicRoughness", Type::object},
        {"/pbrMetallicRoughness/baseColorFactor", Type::numbers, "", 4},
        {"/pbrMetallicRoughness/metallicFactor", Type::number},
        {"/pbrMetallicRoughness/roughnessFactor", Type::number},
        {"/extensions/KHR_materials_emissive_strength/emissiveStrength", Type::number},
        {"/extensions/KHR_materials_ior/ior", Type::number},
        {"/extensions/KHR_materials_pbrSpecularGlossiness/diffuseFactor", Type::numbers, "", 4},
        {"/extensions/KHR_materials_pbrSpecularGlossiness/specularFactor", Type::numbers, "", 3},
        {"/extensions/KHR_materials_transmission/transmissionFactor", Type::number},
        {"/extensions/KHR_materials_volume/attenuationColor", Type::numbers, "", 3},
        {"/extensions/KHR_materials_volume/attenuationDistance", Type::number},
        {"/extensions/KHR_materials_volume/thicknessFactor", Type::number},
    };
    // Some of these are not read, but a dangling index in them still means a broken file.
    for (const std::string texture :
         {"/emissiveTexture", "/normalTexture", "/occlusionTexture", "/pbrMetallicRoughness/baseColorTexture",
          "/pbrMetallicRoughness/metallicRoughnessTexture",
          "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture",
          "/extensions/KHR_materials_pbrSpecularGlossiness/specularGlossinessTexture",
          "/extensions/KHR_materials_transmission/transmissionTexture",
          "/extensions/KHR_materials_volume/thicknessTexture"}) {
        const std::string transform = texture + "/extensions/KHR_texture_transform";
        rules.push_back({texture, Type::object});
        rules.push_back({texture + "/index", Type::index, "/textures"});
        rules.push_back({texture + "/texCoord", Type::natural_31_bit});
        rules.push_back({transform + "/offset", Type::numbers, "", 2});
        rules.push_back({transform + "/rotation", Type::number});
        rules.push_back({transform + "/scale", Type::numbers, "", 2});
        rules.push_back({transform + "/texCoord", Type::natural_31_bit});
    }
    return rules;
}

std::vector<ListRules> list_rules() {
    return {
        {"/accessors",
         {{"/bufferView", Type::index, "/bufferViews"},
          {"/byteOffset", Type::natural},
          {"/componentType", Type::natural_31_bit},
          {"/count", Type::natural},
          {"/normalized", Type::flag},
          {"/type", Type::text},
          {"/sparse", Type::object},
          {"/sparse/count", Type::natural_31_bit},
          {"/sparse/indices", Type::object},
          {"/sparse/indices/bufferView", Type::index, "/bufferViews"},
          {"/sparse/indices/byteOffset", Type::natural_31_bit},
          {"/sparse/indices/componentType", Type::natural_31_bit},
          {"/sparse/values", Type::object},
          {"/sparse/values/bufferView", Type::index, "/bufferViews"},
          {"/sparse/values/byteOffset", Type::natural_31_bit}}},
        {"/buffers", {{"/byteLength", Type::natural}, {"/uri", Type::text}}},
        {"/bufferViews",
         {{"/buffer", Type::index, "/buffers"},
          {"/byteOffset", Type::natural},
          {"/byteLength", Type::natural},
          {"/byteStride", Type::natural}}},
        {"/cameras",
         {{"/name", Type::text},
          {"/type", Type::text},
          {"/perspective", Type::object},
          {"/perspective/yfov", Type::number}}},
        {"/images",
         {{"/name", Type::text}, {"/uri", Type::text}, {"/bufferView", Type::index, "/bufferViews"}}},
        {light_list,
         {{"/name", Type::text},
          {"/type", Type::text},
          {"/color", Type::numbers, "", 3},
          {"/intensity", Type::number},
          {"/range", Type::number},
          {"/spot", Type::object},
          {"/spot/innerConeAngle", Type::number},
          {"/spot/outerConeAngle", Type::number}}},
        {"/materials", material_rules()},
        {"/meshes", {{"/name", Type::text}, {"/weights", Type::number_list}}},
        {"/nodes",
         {{"/name", Type::text},
          {"/camera", Type::index, "/cameras"},
          {"/children", Type::indices, "/nodes"},
          {"/mesh", Type::index, "/meshes"},
          {"/skin", Type::index, "/skins"},
          {"/weights", Type::number_list},
          {"/matrix", Type::numbers, "", 16},
          {"/rotation", Type::numbers, "", 4},
          {"/scale", Type::numbers, "", 3},
          {"/translation", Type::numbers, "", 3},
          {"/extensions/EXT_mesh_gpu_instancing/attributes", Type::indices, "/accessors"},
          {"/extensions/KHR_lights_punctual/light", Type::index, light_list},
          {"/extensions/KHR_node_visibility/visible", Type::flag}}},
        {"/samplers",
         {{"/magFilter", Type::natural_31_bit},
          {"/wrapS", Type::natural_31_bit},
          {"/wrapT", Type::natural_31_bit}}},
        {"/scenes", {{"/nodes", Type::indices, "/nodes"}}},
        {"/skins",
         {{"/joints", Type::indices, "/nodes"},
          {"/inverseBindMatrices", Type::index, "/accessors"},
          {"/skeleton", Type::index, "/nodes"}}},
        {"/textures",
         {{"/sampler", Type::index, "/samplers"}, {"/source", Type::natural_31_bit}, {"/name", Type::text}}},
    };
}

/// The value at `pointer`, or null.
const Json& find(const Json& value, const char* pointer) {
    static const Json nothing;
    const Pointer place(pointer);
    return value.contains(place) ? value.at(place) : nothing;
}

std::uint64_t natural_or(const Json& object, const char* key, std::uint64_t missing) {
    return object.contains(key) ? object.at(key).get<std::uint64_t>() : missing;
}

void check_index(const Json& index, const Json& document, const Rule& rule, const std::string& where) {
    const std::string list = std::string(rule.target).substr(std::string_view(rule.target).rfind('/') + 1);
    if (!index.is_number_unsigned()) throw InputError(fmt::format("{} is not an index into {}", where, list));
    const std::size_t size = find(document, rule.target).size();
    if (index.get<std::uint64_t>() >= size)
        throw InputError(
            fmt::format("{} is {}, but the file has {} {}", where, index.get<std::uint64_t>(), size, list));
}

void check_indices(const Json& indices, const Json& document, const Rule& rule, const std::string& where) {
    if (!indices.is_structured()) throw InputError(fmt::format("{} has the wrong type", where));
    for (const auto& [key, index] : indices.items())
        check_index(index, document, rule, fmt::format("{}/{}", where, key));
}

bool is_float(const Json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= std::numeric_limits<float>::max();
}

bool are_floats(const Json& value) {
    return value.is_array() && std::all_of(value.begin(), value.end(), is_float);
}

bool has_type(const Json& value, const Rule& rule) {
    switch (rule.type) {
        case Type::object:
            return value.is_object();
        case Type::flag:
            return value.is_boolean();
        case Type::text:
            return value.is_string();
        case Type::number:
            return is_float(value);
        case Type::numbers:
            return value.size() == rule.length && are_floats(value);
        case Type::number_list:
            return are_floats(value);
        case Type::natural:
            return value.is_number_unsigned();
        case Type::natural_31_bit:
            return value.is_number_unsigned() &&
                   value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
        case Type::index:
        case Type::indices:
            break;
    }
    return true;
}

void check_object(const Json& object, const std::vector<Rule>& rules, const Json& document,
                  const std::string& where) {
    if (!object.is_object()) throw InputError(fmt::format("{} is not an object", where));
    for (const Rule& rule : rules) {
        const Pointer property(rule.property);
        if (!object.contains(property)) continue;
        const Json& value = object.at(property);
        const std::string place = where + rule.property;
        if (rule.type == Type::index) {
            check_index(value, document, rule, place);
        } else if (rule.type == Type::indices) {
            check_indices(value, document, rule, place);
        } else if (!has_type(value, rule)) {
            throw InputError(fmt::format("{} has the wrong type, range or length", place));
        }
    }
}

void check_list(const Json& list, const std::vector<Rule>& rules, const Json& document,
                const std::string& where) {
    if (!list.is_array()) throw InputError(fmt::format("{} is not a list", where));
    for (std::size_t i = 0; i < list.size(); ++i)
        check_object(list[i], rules, document, fmt::format("{}/{}", where, i));
}

void check_targets(const Json& primitive, const Json& document, const std::string& where) {
    const Json& targets = find(primitive, "/targets");
    if (targets.is_null()) return;
    if (!targets.is_array()) throw InputError(fmt::format("{}/targets is not a list", where));
    const Rule target{"", Type::indices, "/accessors"};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const std::string place = fmt::format("{}/targets/{}", where, i);
        if (!targets[i].is_object()) throw InputError(fmt::format("{} is not an object", place));
        check_indices(targets[i], document, target, place);
    }
}

void check_primitives(const Json& document) {
    const Json& meshes = find(document, "/meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (!meshes[i].contains("primitives")) continue;
        const Json& primitives = meshes[i]["primitives"];
        const std::string where = fmt::format("meshes/{}/primitives", i);
        check_list(primitives, primitive_rules(), document, where);
        for (std::size_t k = 0; k < primitives.size(); ++k)
            check_targets(primitives[k], document, fmt::format("{}/{}", where, k));
    }
}

void check_buffer_views(const Json& document) {
    const Json& views = find(document, "/bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i].contains("buffer")) continue;
        const Json& buffer = document.at("buffers").at(views[i]["buffer"].get<std::size_t>());
        const std::uint64_t size = natural_or(buffer, "byteLength", 0);
        const std::uint64_t offset = natural_or(views[i], "byteOffset", 0);
        const std::uint64_t length = natural_or(views[i], "byteLength", 0);
        if (length == 0) throw InputError(fmt::format("bufferViews/{} is empty", i));
        if (offset > size || length > size - offset)
            throw InputError(fmt::format("bufferViews/{} goes beyond the end of its buffer", i));
    }
}

struct Version {
    int major = 0;
    int minor = 0;
};

Version parse_version(const Json& value, const char* where) {
    Version version;
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        const char* end = text.data() + text.size();
        const auto major = std::from_chars(text.data(), end, version.major);
        if (major.ec == std::errc{} && major.ptr != end && *major.ptr == '.') {
            const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
            if (minor.ec == std::errc{} && minor.ptr == end) return version;
        }
    }
    throw InputError(fmt::format("is not glTF 2.0: asset/{} is missing or not a version", where));
}

void check_version(const Json& document) {
    const Version version = parse_version(find(document, "/asset/version"), "version");
    if (version.major != 2)
        throw InputError(fmt::format("is glTF {}.{}; glTF 2.0 is needed", version.major, version.minor));
    const Json& minimum = find(document, "/asset/minVersion");
    if (minimum.is_null()) return;
    const Version needed = parse_version(minimum, "minVersion");
    if (needed.major != 2 || needed.minor > 0)
        throw InputError(
            fmt::format("needs a reader of glTF {}.{}; this one reads 2.0", needed.major, needed.minor));
}

}  // namespace

void check_json(const Json& document) {
    if (!document.is_object()) throw InputError("is not glTF: its JSON is not an object");
    check_version(document);
    for (const ListRules& checked : list_rules()) {
        const Pointer place(checked.list);
        if (document.contains(place))
            check_list(document.at(place), checked.rules, document, checked.list + 1);
    }
    const Rule default_scene{"/scene", Type::index, "/scenes"};
    check_object(document, {default_scene}, document, "");
    check_primitives(document);
    check_buffer_views(document);
}

}  // namespace common::gltf
