// The two forms in which a glTF file comes: JSON text, or a GLB container of JSON and binary data.
// glTF 2.0, section 4 (GLB File Format Specification).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace common::gltf {

/// Returns the bytes of a file. Throws InputError if it cannot be read.
[[nodiscard]] std::vector<std::uint8_t> read_file(const std::filesystem::path& file);

/// The parts of a glTF file.
struct Container {
    std::string json;
    std::vector<std::uint8_t> binary;  ///< the BIN chunk; empty for .gltf
};

/// Splits a .gltf or .glb file, which are told apart by their first bytes. Throws InputError for a GLB of
/// another version or one whose chunks do not fit into the file.
[[nodiscard]] Container parse_container(std::span<const std::uint8_t> file);

/// Does the same for a file; also throws InputError if it cannot be read.
[[nodiscard]] Container read_container(const std::filesystem::path& file);

/// Makes a GLB of a JSON chunk and, if `binary` is not empty, a BIN chunk. Throws InputError if the result
/// would have 4 GiB or more.
[[nodiscard]] std::vector<std::uint8_t> make_glb(std::string_view json, std::span<const std::uint8_t> binary);

}  // namespace common::gltf
