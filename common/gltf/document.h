// glTF file -> tinygltf model whose indices and ranges can be relied on.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>

#include "common/gltf/warnings.h"

namespace common::gltf {

/// Reads `file` with its buffers. All indices between the model's lists are in range (but
/// Texture::source), and all buffer views
/// inside their buffers. Animations are left out, with a warning. Images are not decoded; read_images() says
/// what they hold. Throws InputError for everything that is wrong with the file.
[[nodiscard]] tinygltf::Model read_document(const std::filesystem::path& file, Warnings& warnings);

}  // namespace common::gltf
