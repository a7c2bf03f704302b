// The bytes that a glTF document describes: buffers and encoded images.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace common::gltf {

/// Reads the buffers of a document that check_json() has passed; their files are relative to `directory`.
/// `binary` is the BIN chunk, which is the first buffer if that has no uri. Throws InputError for a buffer
/// that cannot be read, has fewer bytes than it states, or exists in compressed form only.
[[nodiscard]] std::vector<tinygltf::Buffer> read_buffers(const nlohmann::json& document,
                                                         std::vector<std::uint8_t> binary,
                                                         const std::filesystem::path& directory);

/// Reads the images of a document that check_json() has passed, without decoding them. An image with a buffer
/// view stays there; any other holds the bytes of its file in `Image::image`. Images that no material needs,
/// or that cannot be read, hold nothing.
[[nodiscard]] std::vector<tinygltf::Image> read_images(const nlohmann::json& document,
                                                       const std::filesystem::path& directory);

}  // namespace common::gltf
