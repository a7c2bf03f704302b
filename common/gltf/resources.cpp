#include "common/gltf/resources.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "common/core/input_error.h"
#include "common/gltf/compression.h"
#include "common/gltf/uri.h"

namespace common::gltf {
namespace {

using Json = nlohmann::json;

std::string text_or_empty(const Json& object, const char* key) {
    return object.contains(key) ? object.at(key).get<std::string>() : std::string();
}

std::vector<std::uint8_t> bytes_of_buffer(const Json& document, std::size_t i,
                                          std::vector<std::uint8_t>& binary,
                                          const std::filesystem::path& directory) {
    const Json& buffer = document.at("buffers").at(i);
    if (buffer.contains("uri")) {
        const std::string uri = buffer.at("uri").get<std::string>();
        try {
            return read_uri(uri, directory);
        } catch (const InputError& error) {
            const std::string file = is_data_uri(uri) ? "" : fmt::format(": '{}'", percent_decoded(uri));
            throw InputError(fmt::format("buffers/{}{} {}", i, file, error.what()));
        }
    }
    if (i == 0 && !binary.empty()) return std::move(binary);
    const std::string compression = compression_of_buffer(document, i);
    if (!compression.empty())
        throw InputError(fmt::format("buffers/{} is compressed with {}, which is not read", i, compression));
    throw InputError(fmt::format("buffers/{} has no data: the file has no uri for it and no BIN chunk", i));
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

tinygltf::Image read_image(const Json& described, bool is_needed, const std::filesystem::path& directory) {
    tinygltf::Image image;
    image.as_is = true;
    image.name = text_or_empty(described, "name");
    if (described.contains("bufferView")) {
        // Not copied: the image is decoded from the buffer view.
        image.bufferView = described.at("bufferView").get<int>();
        return image;
    }
    const std::string uri = text_or_empty(described, "uri");
    if (!is_data_uri(uri)) image.uri = uri;
    if (!is_needed) return image;
    try {
        image.image = read_uri(uri, directory);
    } catch (const InputError&) {
        // An image without bytes is an error when it is decoded, with its name.
    }
    return image;
}

}  // namespace

std::vector<tinygltf::Buffer> read_buffers(const Json& document, std::vector<std::uint8_t> binary,
                                           const std::filesystem::path& directory) {
    std::vector<tinygltf::Buffer> buffers;
    if (!document.contains("buffers")) return buffers;
    for (std::size_t i = 0; i < document.at("buffers").size(); ++i) {
        const Json& described = document.at("buffers").at(i);
        if (!described.contains("byteLength"))
            throw InputError(fmt::format("buffers/{} has no byteLength", i));
        tinygltf::Buffer buffer;
        buffer.data = bytes_of_buffer(document, i, binary, directory);
        // The file may be longer than the buffer that it holds (glTF 2.0, section 3.6.1.1).
        const auto length = described.at("byteLength").get<std::uint64_t>();
        if (buffer.data.size() < length)
            throw InputError(fmt::format("buffers/{} has {} of its {} bytes", i, buffer.data.size(), length));
        buffers.push_back(std::move(buffer));
    }
    return buffers;
}

std::vector<tinygltf::Image> read_images(const Json& document, const std::filesystem::path& directory) {
    std::vector<tinygltf::Image> images;
    if (!document.contains("images")) return images;
    const std::set<std::size_t> needed = needed_images(document);
    for (std::size_t i = 0; i < document.at("images").size(); ++i)
        images.push_back(read_image(document.at("images").at(i), needed.contains(i), directory));
    return images;
}

}  // namespace common::gltf
