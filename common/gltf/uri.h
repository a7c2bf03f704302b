// What a glTF file refers to by URI: files beside it, and data in the URI itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace common::gltf {

/// True for a data URI (RFC 2397).
[[nodiscard]] bool is_data_uri(const std::string& uri);

/// The file name that a relative URI stands for: only percent codes are codes, and a percent sign without two
/// hexadecimal digits stands for itself (RFC 3986, section 2.1).
[[nodiscard]] std::string percent_decoded(const std::string& uri);

/// The bytes of a data URI, or of the file that a relative one names beside `directory`. Throws InputError,
/// with what is wrong but not the URI, where they cannot be read.
[[nodiscard]] std::vector<std::uint8_t> read_uri(const std::string& uri,
                                                 const std::filesystem::path& directory);

}  // namespace common::gltf
