// Loads from two image files the pixels that can be compared.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace common {

/// The layer that two images have in common, and the pixels to compare.
struct ComparableImages {
    std::string layer;  ///< "irradiance" (channels irradiance.R, .G, .B), W/m^2; else "radiance" (R, G, B)
    int x = 0, y = 0;   ///< position of the first pixel in the picture, which is OpenEXR's display window
    int width = 0, height = 0;
    std::vector<Rgb> image, reference;  ///< all pixels, row by row from the top left; finite

    /// Indices of the pixels where the reference shows a surface (its channel A is not 0), in order; all
    /// pixels if it has no A.
    std::vector<std::size_t> compared;

    /// Number of pixels where only one of the two shows a surface; empty unless both have an A.
    std::optional<std::size_t> coverage_differs;
};

/// Loads two linear images, files of floating-point values. Pixels are matched by their position in the
/// picture; pixels outside the picture are left out.
///
/// Throws InputError, naming the file, in these cases: a file cannot be read or holds display colours; the
/// pictures differ in size; the files hold different parts of the picture; they have no common layer; values
/// of the layer or of A are not finite; the reference shows no surface at all.
[[nodiscard]] ComparableImages load_comparable(const std::filesystem::path& image,
                                               const std::filesystem::path& reference);

}  // namespace common
