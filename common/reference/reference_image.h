// A reference as a file: the irradiance at each pixel's point and its variance.
#pragma once

#include "common/image/image.h"
#include "common/reference/reference_pass.h"

namespace common::reference {

struct ReferencePoint {
    bool present = false;     ///< whether the pixel sees a diffuse surface; if not, everything else is 0
    Rgb irradiance{0, 0, 0};  ///< W/m^2, direct and indirect, for the shading normal
    Rgb variance{0, 0, 0};    ///< of the estimate `irradiance`, (W/m^2)^2
    Vec3 position{0, 0, 0};
    Vec3 normal{0, 0, 0};            ///< unit, shading, on the side that is seen
    Vec3 geometric_normal{0, 0, 0};  ///< unit, on the side that is seen
    Rgb irradiance_low{0, 0, 0};     ///< rounding error of `irradiance`: a run continues from exact sums
    Rgb variance_low{0, 0, 0};       ///< the same for `variance`
};

struct ReferenceImage {
    int width = 0, height = 0;
    std::vector<ReferencePoint> pixel;  ///< row by row from the top left one
    ImageNotes notes;
};

/// Makes an image with channels R, G, B, A, as in render(); irradiance, variance, irradiance_low and
/// variance_low .R .G .B; position, normal and geometric_normal .X .Y .Z. See ReferencePoint.
[[nodiscard]] Image to_image(std::span<const VisibleSurface> pixels, int width, int height,
                             const ReferenceSums& sums);

/// Reads what to_image() made from an OpenEXR file. Throws InputError if it cannot be read, if a channel is
/// missing, or if a value is not finite or not valid.
[[nodiscard]] ReferenceImage read_reference(const std::filesystem::path& file);

}  // namespace common::reference
