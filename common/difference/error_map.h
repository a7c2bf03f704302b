// An error per pixel as a picture.
#pragma once

#include <filesystem>
#include <span>

#include "common/image/image.h"

namespace common {

/// From black for 0 by way of purple and orange to pale yellow for 1: the colour map magma, which grows
/// brighter all the way and so reads the same in grey.
[[nodiscard]] DisplayColor magma(float value);

/// Writes one value from 0 to 1 per pixel, row by row from the top left, as an sRGB PNG in magma. Throws
/// InputError where it cannot be written, and unless there are width * height values.
void write_flip_map(const std::filesystem::path& file, int width, int height, std::span<const float> map);

}  // namespace common
