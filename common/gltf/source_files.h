// Lists the files that a scene is read from.
#pragma once

#include <filesystem>
#include <vector>

namespace common {

/// Returns a glTF file and the buffers and images that it has in separate files, whether these exist or not.
/// For a file that is not glTF, returns only that file; loading it reports the error.
[[nodiscard]] std::vector<std::filesystem::path> source_files(const std::filesystem::path& gltf);

}  // namespace common
