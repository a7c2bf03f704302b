// Data that a glTF file refers to by URI: files beside it, and data in the URI itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace common::gltf {

/// Returns true for a data URI (RFC 2397).
[[nodiscard]] bool is_data_uri(const std::string& uri);

/// Returns the file name that a relative URI stands for. Only percent codes are decoded; a percent sign
/// without two hexadecimal digits stands for itself (RFC 3986, section 2.1).
[[nodiscard]] std::string percent_decoded(const std::string& uri);

/// Returns the bytes of a data URI, or of the file in `directory` that a relative URI names. Throws
/// InputError, with the reason but not the URI, if they cannot be read.
[[nodiscard]] std::vector<std::uint8_t> read_uri(const std::string& uri,
                                                 const std::filesystem::path& directory);

}  // namespace common::gltf
