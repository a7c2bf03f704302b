// What each pixel of a camera sees, before anybody asks how bright it is.
#pragma once

#include <vector>

#include "common/tracer/ray_scene.h"

namespace common {

/// The diffuse surface seen through one pixel's centre, directly or by way of mirrors and glass.
struct VisibleSurface {
    bool present = false;  ///< false: the pixel sees the sky, or nothing
    SurfacePoint point;
    Rgb throughput{1, 1, 1};   ///< what mirrors and glass on the way leave of it
    Rgb reflectance{0, 0, 0};  ///< of the surface: radiance = reflectance / pi * irradiance
    Rgb emitted{0, 0,
                0};  ///< W/(m^2 sr) towards the camera by the surface, or by the sky where none is present
};

/// Row by row from the top left pixel. Glass is looked through; its own reflection is shown only where it is
/// total. So are holes; what is there in part is seen with that probability, by numbers that belong to the
/// pixel: the same in every call, and right on average over many pixels.
[[nodiscard]] std::vector<VisibleSurface> visible_surfaces(const RayScene& rays, const Camera& camera,
                                                           int width, int height);

}  // namespace common
