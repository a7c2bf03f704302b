#include "common/gltf/compression.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "common/core/input_error.h"

namespace common::gltf {
namespace {

using Json = nlohmann::json;

constexpr const char* draco = "KHR_draco_mesh_compression";

/// Returns the name of an object's extension for compressed buffers: EXT_meshopt_compression, or the same
/// with another vendor's prefix.
std::string buffer_compression(const Json& object) {
    if (!object.contains("extensions") || !object.at("extensions").is_object()) return {};
    for (const auto& [name, extension] : object.at("extensions").items()) {
        if (name.ends_with("meshopt_compression")) return name;
    }
    return {};
}

struct Signature {
    std::size_t offset;
    std::string_view bytes;
    std::string_view format;
};

constexpr std::array<Signature, 7> signatures = {{{8, "WEBP", "WebP"},
                                                  {1, "KTX 20", "KTX2"},
                                                  {1, "KTX 11", "KTX"},
                                                  {0, "DDS ", "DDS"},
                                                  {4, "ftypavif", "AVIF"},
                                                  {0, "sB", "Basis"},
                                                  {0, "<svg", "SVG"}}};

bool has_data(const tinygltf::Model& model, int accessor) {
    const tinygltf::Accessor& described = model.accessors[static_cast<std::size_t>(accessor)];
    return described.bufferView >= 0 || described.sparse.isSparse;
}

}  // namespace

std::string compression_of_buffer(const Json& document, std::size_t buffer) {
    std::string name = buffer_compression(document.at("buffers").at(buffer));
    if (!name.empty() || !document.contains("bufferViews")) return name;
    for (const Json& view : document.at("bufferViews")) {
        if (view.contains("buffer") && view.at("buffer") == buffer) name = buffer_compression(view);
        if (!name.empty()) break;
    }
    return name;
}

void check_compression(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    if (!primitive.extensions.contains(draco)) return;
    bool is_whole = primitive.attributes.contains("POSITION");
    for (const auto& [name, accessor] : primitive.attributes)
        is_whole = is_whole && has_data(model, accessor);
    if (primitive.indices >= 0) is_whole = is_whole && has_data(model, primitive.indices);
    if (!is_whole) throw InputError(fmt::format("is compressed with {}, which is not read", draco));
}

std::string_view foreign_image_format(std::span<const unsigned char> encoded) {
    const std::string_view text(reinterpret_cast<const char*>(encoded.data()), encoded.size());
    for (const Signature& signature : signatures) {
        if (text.size() >= signature.offset && text.substr(signature.offset).starts_with(signature.bytes))
            return signature.format;
    }
    return {};
}

}  // namespace common::gltf
