// Compressed parts of a glTF file. They are not read; errors name them where there is no uncompressed form.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace common::gltf {

/// Returns the extension that holds the data of a buffer without bytes of its own; empty if there is none.
[[nodiscard]] std::string compression_of_buffer(const nlohmann::json& document, std::size_t buffer);

/// Throws InputError, naming the extension, for a primitive that exists in compressed form only.
void check_compression(const tinygltf::Model& model, const tinygltf::Primitive& primitive);

/// Returns the image format that the first bytes indicate, if it belongs to a glTF extension or is another
/// one found in glTF files; empty for all others.
[[nodiscard]] std::string_view foreign_image_format(std::span<const unsigned char> encoded);

}  // namespace common::gltf
