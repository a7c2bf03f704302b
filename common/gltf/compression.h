// Compressed parts of a glTF file: they are not read, but named where there is nothing else to read.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace common::gltf {

/// The extension that has the data of a buffer without bytes of its own; empty where none has.
[[nodiscard]] std::string compression_of_buffer(const nlohmann::json& document, std::size_t buffer);

/// Throws InputError, naming the extension, for a primitive that is there in compressed form only.
void check_compression(const tinygltf::Model& model, const tinygltf::Primitive& primitive);

/// What the first bytes of an encoded image say that it is, where that is a format of glTF's extensions and
/// others that are met in glTF files; empty for all others.
[[nodiscard]] std::string_view foreign_image_format(std::span<const unsigned char> encoded);

}  // namespace common::gltf
