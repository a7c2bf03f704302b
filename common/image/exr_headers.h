// A look at an OpenEXR file before OpenEXR reads it.
#pragma once

#include <filesystem>

namespace common {

/// Throws InputError unless the headers lie within the file. OpenEXR takes the size of an attribute at its
/// word and makes room for it, 2 GiB for a broken file of 6 KiB.
void check_exr_headers(const std::filesystem::path& file);

}  // namespace common
