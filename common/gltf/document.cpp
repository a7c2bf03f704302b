#include "common/gltf/document.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/core/input_error.h"
#include "common/gltf/check_json.h"
#include "common/gltf/container.h"
#include "common/gltf/extensions.h"
#include "common/gltf/resources.h"

namespace common::gltf {
namespace {

using Json = nlohmann::json;

/// Limit of nesting, deeper than any real file. Recursive walks over the values must not overflow the stack.
constexpr int deepest_nesting = 100;

void check_nesting(const std::string& text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') in_string = !in_string;
        if (in_string) {
            if (c == '\\') ++i;
            continue;
        }
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > deepest_nesting) throw InputError("has JSON that is nested too deeply");
    }
}

Json parse_json(const std::string& text) {
    check_nesting(text);
    try {
        return Json::parse(text);
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("is not glTF: {}", error.what()));
    }
}

/// Turns floats such as 3.0 into integers. JSON allows an integer to be written so, but tinygltf rejects it.
void turn_whole_floats_into_integers(Json& value) {
    constexpr double largest = 9007199254740992;  // beyond 2^53 doubles do not represent all integers
    if (value.is_structured()) {
        for (Json& element : value) turn_whole_floats_into_integers(element);
    } else if (value.is_number_float()) {
        const double number = value.get<double>();
        if (std::trunc(number) != number || std::abs(number) > largest) return;
        if (number < 0) {
            value = static_cast<std::int64_t>(number);
        } else {
            value = static_cast<std::uint64_t>(number);
        }
    }
}

/// Works around tinygltf, which truncates integers in extensions to 32 bits but reads floats as they are.
void turn_large_integers_of_extensions_into_floats(Json& value, bool is_in_extension = false) {
    if (value.is_object()) {
        for (const auto& [key, element] : value.items())
            turn_large_integers_of_extensions_into_floats(element, is_in_extension || key == "extensions");
    } else if (value.is_array()) {
        for (Json& element : value) turn_large_integers_of_extensions_into_floats(element, is_in_extension);
    } else if (is_in_extension && value.is_number_integer()) {
        const double number = value.get<double>();
        if (std::abs(number) > std::numeric_limits<std::int32_t>::max()) value = number;
    }
}

std::string element_name(const Json& element, const char* list, std::size_t i) {
    const bool is_named = element.is_object() && element.contains("name") && element["name"].is_string() &&
                          !element["name"].get_ref<const std::string&>().empty();
    return is_named ? fmt::format("'{}'", element["name"].get_ref<const std::string&>())
                    : fmt::format("{}/{}", list, i);
}

void warn_about_animations(const Json& document, Warnings& warnings) {
    if (!document.contains("animations") || !document["animations"].is_array()) return;
    const Json& animations = document["animations"];
    for (std::size_t i = 0; i < animations.size(); ++i)
        warnings.add("animations not played", element_name(animations[i], "animations", i));
}

/// The parts that are read here instead of by tinygltf. It decodes URIs differently, requires files to be
/// exactly as long as their buffers, and rejects skins without inverse bind matrices and indices without a
/// buffer view.
struct ReadHere {
    std::vector<tinygltf::Buffer> buffers;
    std::vector<tinygltf::Image> images;
    std::vector<tinygltf::Skin> skins;
    std::vector<int> indices;  ///< of all primitives of all meshes, -1 where there are none
};

std::vector<tinygltf::Skin> read_skins(const Json& document) {
    std::vector<tinygltf::Skin> skins;
    if (!document.contains("skins")) return skins;
    for (const Json& described : document["skins"]) {
        tinygltf::Skin skin;
        skin.inverseBindMatrices = described.value("inverseBindMatrices", -1);
        if (described.contains("joints") && described["joints"].is_array())
            skin.joints = described["joints"].get<std::vector<int>>();
        skins.push_back(std::move(skin));
    }
    return skins;
}

std::vector<int> take_out_indices(Json& document) {
    std::vector<int> indices;
    if (!document.contains("meshes")) return indices;
    for (Json& mesh : document["meshes"]) {
        if (!mesh.contains("primitives")) continue;
        for (Json& primitive : mesh["primitives"]) {
            indices.push_back(primitive.value("indices", -1));
            primitive.erase("indices");
        }
    }
    return indices;
}

/// Takes these parts out of the document, and removes everything that is not read, so that it cannot stop the
/// file from loading.
ReadHere take_out(Json& document, std::vector<std::uint8_t> binary, const std::filesystem::path& directory) {
    ReadHere parts{read_buffers(document, std::move(binary), directory), read_images(document, directory),
                   read_skins(document), take_out_indices(document)};
    for (const char* part : {"buffers", "images", "skins", "animations", "extras"}) document.erase(part);
    return parts;
}

void put_in(ReadHere parts, tinygltf::Model& model) {
    model.buffers = std::move(parts.buffers);
    model.images = std::move(parts.images);
    model.skins = std::move(parts.skins);
    auto indices = parts.indices.begin();
    for (tinygltf::Mesh& mesh : model.meshes) {
        for (tinygltf::Primitive& primitive : mesh.primitives) {
            if (indices == parts.indices.end()) throw InputError("has a primitive that is not readable");
            primitive.indices = *indices++;
        }
    }
}

tinygltf::Model parse_with_tinygltf(const std::string& json) {
    if (json.size() > std::numeric_limits<unsigned int>::max())
        throw InputError("has more than 4 GiB of JSON");
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string error, warning;
    bool is_read = false;
    try {
        is_read = reader.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                             static_cast<unsigned int>(json.size()), "");
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    // If a part is malformed, tinygltf can drop it, note an error and still report success.
    if (!is_read || !error.empty()) throw InputError(error.empty() ? "is not readable as glTF" : error);
    return model;
}

}  // namespace

tinygltf::Model read_document(const std::filesystem::path& file, Warnings& warnings) {
    Container container = read_container(file);
    Json document = parse_json(container.json);
    turn_whole_floats_into_integers(document);
    if (document.is_object()) check_extensions(document, warnings);
    check_json(document);
    warn_about_animations(document, warnings);
    ReadHere parts = take_out(document, std::move(container.binary), file.parent_path());
    turn_large_integers_of_extensions_into_floats(document);
    tinygltf::Model model = parse_with_tinygltf(document.dump());
    put_in(std::move(parts), model);
    return model;
}

}  // namespace common::gltf
