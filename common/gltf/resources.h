// The bytes that a glTF document describes: buffers and encoded images.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace common::gltf {

/// The buffers of a document that check_json() has passed, those of files beside `directory`. `binary` is the
/// BIN chunk, which is the first buffer where that has no uri. Throws InputError for one that cannot be read,
/// has fewer bytes than it says, or is there in compressed form only.
[[nodiscard]] std::vector<tinygltf::Buffer> read_buffers(const nlohmann::json& document,
                                                         std::vector<std::uint8_t> binary,
                                                         const std::filesystem::path& directory);

/// The images of a document that check_json() has passed, not decoded: those with a buffer view are to be
/// taken from it, the others hold the bytes of their file in `Image::image`. Images that no material needs
/// hold nothing, nor do those that cannot be read.
[[nodiscard]] std::vector<tinygltf::Image> read_images(const nlohmann::json& document,
                                                       const std::filesystem::path& directory);

}  // namespace common::gltf
