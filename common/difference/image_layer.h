// Two image files -> the pixels of them that can be compared.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace common {

/// The layer that two images have in common, and where both are to be compared.
struct ComparableImages {
    std::string layer;  ///< "irradiance" (channels irradiance.R, .G, .B), W/m^2; else "radiance" (R, G, B)
    int x = 0, y = 0;   ///< where the first pixel lies in the picture: OpenEXR's display window
    int width = 0, height = 0;
    std::vector<Rgb> image, reference;  ///< all pixels, row by row from the top left; finite

    /// Pixels that the reference has a surface in (its channel A is not 0), in order; all without an A.
    std::vector<std::size_t> compared;

    /// Pixels that one of the two has a surface in and the other none; empty unless both have an A.
    std::optional<std::size_t> coverage_differs;
};

/// Linear images: files of floating-point values. Pixels go by their place in the picture; those that a file
/// has beside it are left out.
///
/// Throws InputError, naming the file, for one that cannot be read or holds display colours, for pictures of
/// different sizes and files that do not have the same part of them, for no common layer, for values of the
/// layer or of A that are not finite, and where the reference has no surface at all.
[[nodiscard]] ComparableImages load_comparable(const std::filesystem::path& image,
                                               const std::filesystem::path& reference);

}  // namespace common
