// Where an image goes, looked at before the work starts.
#pragma once

#include <string>

namespace bench {

/// Throws InputError where `out` is no .exr file in a folder that can be written to, or the size is not one
/// of an image.
void check_image_output(const std::string& out, int width, int height);

}  // namespace bench
