// Which files a scene is read from.
#pragma once

#include <filesystem>
#include <vector>

namespace common {

/// A glTF file, then the buffers and images that are files of their own, whether they are there or not. Of a
/// file that is no glTF, itself alone: to load it says why.
[[nodiscard]] std::vector<std::filesystem::path> source_files(const std::filesystem::path& gltf);

}  // namespace common
