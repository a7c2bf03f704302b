#include "common/gltf/document.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>

#include "common/core/input_error.h"
#include "common/gltf/check_json.h"
#include "common/gltf/container.h"
#include "common/gltf/extensions.h"

namespace common::gltf {
namespace {

using Json = nlohmann::json;

/// Deeper nesting than any real file has; what walks over the values recursively must not run out of stack.
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

/// JSON lets a writer spell an integer "3.0"; tinygltf does not take that for one.
void turn_whole_floats_into_integers(Json& value) {
    constexpr double largest = 2147483647;  // no index or count of a real file is larger
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

/// tinygltf cuts integers in extensions down to 32 bits; a factor may be larger.
void turn_large_integers_into_floats(Json& value) {
    constexpr double largest = 2147483647;
    if (value.is_structured()) {
        for (Json& element : value) turn_large_integers_into_floats(element);
    } else if (value.is_number_integer() && std::abs(value.get<double>()) > largest) {
        value = value.get<double>();
    }
}

void check_buffers(const Json& document, bool has_binary) {
    if (has_binary || !document.contains("buffers")) return;
    const Json& buffers = document.at("buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        if (!buffers[i].contains("uri"))
            throw InputError(
                fmt::format("buffers/{} has no data: the file has no uri for it and no BIN chunk", i));
    }
}

/// The file name that a relative URI stands for (RFC 3986, section 2.1).
std::string percent_decoded(const std::string& uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += static_cast<char>(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

/// A file may be longer than the buffer that it holds (glTF 2.0, section 3.6.1.1), but tinygltf wants them
/// equal.
void lengthen_buffers_to_their_files(Json& document, const std::filesystem::path& directory) {
    if (!document.contains("buffers")) return;
    for (Json& buffer : document["buffers"]) {
        if (!buffer.contains("uri") || !buffer.contains("byteLength")) continue;
        std::error_code is_no_file;
        const std::uintmax_t size = std::filesystem::file_size(
            directory / percent_decoded(buffer["uri"].get<std::string>()), is_no_file);
        if (!is_no_file && size > buffer["byteLength"].get<std::uint64_t>()) buffer["byteLength"] = size;
    }
}

std::set<std::size_t> needed_images(const Json& document) {
    std::set<std::size_t> images;
    if (!document.contains("materials")) return images;
    for (const Json& material : document.at("materials")) {
        for (const char* slot : {"/pbrMetallicRoughness/baseColorTexture/index", "/normalTexture/index",
                                 "/emissiveTexture/index",
                                 "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture/index"}) {
            const Json::json_pointer index(slot);
            if (!material.contains(index)) continue;
            const Json& texture = document.at("textures").at(material.at(index).get<std::size_t>());
            if (texture.contains("source")) images.insert(texture.at("source").get<std::size_t>());
        }
    }
    return images;
}

/// Takes out what is not read here, so that nothing in it can stop the file from loading.
void leave_out_unneeded_parts(Json& document) {
    for (const char* part : {"animations", "skins", "extras"}) document.erase(part);
    if (!document.contains("images")) return;
    const std::set<std::size_t> needed = needed_images(document);
    for (std::size_t i = 0; i < document["images"].size(); ++i) {
        if (!needed.contains(i)) document["images"][i] = {{"uri", ""}};
    }
}

/// tinygltf's image callback: keeps the encoded bytes of a file or data URI.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    // A buffer view is not copied; it is there to be read when the image is decoded.
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

tinygltf::Model parse_with_tinygltf(const std::vector<std::uint8_t>& glb, const std::filesystem::path& file) {
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(keep_encoded, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    bool is_read = false;
    try {
        is_read =
            reader.LoadBinaryFromMemory(&model, &error, &warning, glb.data(),
                                        static_cast<unsigned int>(glb.size()), file.parent_path().string());
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    // Where a part is malformed, tinygltf can drop it, note an error and still report success.
    if (!is_read || !error.empty()) throw InputError(error.empty() ? "is not readable as glTF" : error);
    return model;
}

}  // namespace

tinygltf::Model read_document(const std::filesystem::path& file, Warnings& warnings) {
    const Container container = read_container(file);
    Json document = parse_json(container.json);
    turn_whole_floats_into_integers(document);
    if (document.contains("materials")) turn_large_integers_into_floats(document["materials"]);
    if (document.is_object()) check_extensions(document, warnings);
    check_json(document);
    check_buffers(document, !container.binary.empty());
    lengthen_buffers_to_their_files(document, file.parent_path());
    leave_out_unneeded_parts(document);
    return parse_with_tinygltf(make_glb(document.dump(), container.binary), file);
}

}  // namespace common::gltf
