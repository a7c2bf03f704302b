// A reference as a file: what each pixel's point receives, and how well that is known.
#pragma once

#include "common/image/image.h"
#include "common/reference/reference_pass.h"

namespace common::reference {

struct ReferencePoint {
    bool present = false;     ///< whether the pixel sees a diffuse surface; if not, everything else is 0
    Rgb irradiance{0, 0, 0};  ///< W/m^2, direct and indirect, for the shading normal
    Rgb variance{0, 0, 0};    ///< of `irradiance` as an estimate, (W/m^2)^2
    Vec3 position{0, 0, 0};
    Vec3 normal{0, 0, 0};            ///< unit, shading, on the side that is seen
    Vec3 geometric_normal{0, 0, 0};  ///< unit, on the side that is seen
    Rgb irradiance_low{0, 0, 0};     ///< what rounding to float took from `irradiance` and from
    Rgb variance_low{0, 0, 0};       ///< `variance`: a run goes on from their sums
};

struct ReferenceImage {
    int width = 0, height = 0;
    std::vector<ReferencePoint> pixel;  ///< row by row from the top left one
    ImageNotes notes;
};

/// Channels R, G, B, A, as render() has them; irradiance, variance, irradiance_low and variance_low .R .G .B;
/// position, normal and geometric_normal .X .Y .Z: see ReferencePoint.
[[nodiscard]] Image to_image(std::span<const VisibleSurface> pixels, int width, int height,
                             const ReferenceSums& sums);

/// Reads what to_image() made from an OpenEXR file. Throws InputError where it cannot be read, where a
/// channel is missing, or a value is not finite or makes no sense.
[[nodiscard]] ReferenceImage read_reference(const std::filesystem::path& file);

}  // namespace common::reference
