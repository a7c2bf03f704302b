// A check of an OpenEXR file before OpenEXR reads it.
#pragma once

#include <filesystem>

namespace common {

/// Throws InputError unless the headers lie within the file. OpenEXR allocates whatever size an attribute
/// states: 2 GiB for a broken file of 6 KiB.
void check_exr_headers(const std::filesystem::path& file);

}  // namespace common
