// Reads a glTF file into a tinygltf model with checked indices and ranges.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>

#include "common/gltf/warnings.h"

namespace common::gltf {

/// Reads `file` with its buffers. All indices into the model's lists are in range, except Texture::source,
/// and all buffer views are inside their buffers. Leaves out animations, with a warning. Does not decode
/// images; read_images() describes what they hold. Throws InputError for anything that is wrong with the
/// file.
[[nodiscard]] tinygltf::Model read_document(const std::filesystem::path& file, Warnings& warnings);

}  // namespace common::gltf
