// The surface that each pixel of a camera sees, without its irradiance.
#pragma once

#include <vector>

#include "common/tracer/ray_scene.h"

namespace common {

/// The diffuse surface seen through one pixel's centre, directly or through mirrors and glass.
struct VisibleSurface {
    bool present = false;  ///< false: the pixel sees the sky, or nothing
    SurfacePoint point;
    Rgb throughput{1, 1, 1};   ///< the fraction of its radiance that mirrors and glass on the way transmit
    Rgb reflectance{0, 0, 0};  ///< of the surface: radiance = reflectance / pi * irradiance
    Rgb emitted{0, 0,
                0};  ///< W/(m^2 sr) towards the camera by the surface, or by the sky where none is present
};

/// Returns the surfaces row by row from the top left pixel. Rays pass through glass; its own reflection is
/// shown only if it is total. Rays pass through holes. Partial coverage is seen with that probability, by
/// random numbers of the pixel: the same in every call, and right on average over many pixels.
[[nodiscard]] std::vector<VisibleSurface> visible_surfaces(const RayScene& rays, const Camera& camera,
                                                           int width, int height);

}  // namespace common
