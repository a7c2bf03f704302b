// Maps of the error per pixel, written as images.
#pragma once

#include <filesystem>
#include <span>

#include "common/image/image.h"

namespace common {

/// Returns the colour for a value in the colour map magma: black for 0, then purple and orange, pale yellow
/// for 1. Its lightness increases throughout, so that it reads the same in grey.
[[nodiscard]] DisplayColor magma(float value);

/// Writes one value from 0 to 1 per pixel, row by row from the top left, as an sRGB PNG in magma. Throws
/// InputError where it cannot be written, and unless there are width * height values.
void write_flip_map(const std::filesystem::path& file, int width, int height, std::span<const float> map);

}  // namespace common
