// A random place on a light.
#pragma once

#include <optional>

#include "common/reference/light.h"
#include "common/reference/receiver.h"
#include "common/tracer/ray_scene.h"

namespace common::reference {

/// A place on a light as seen from a receiver.
struct LightSample {
    Vec3 towards;    ///< from the receiver's origin to the place; for directional lights unit
    float reach;     ///< distance to the light in units of `towards`: 1, or infinity
    Rgb irradiance;  ///< W/m^2 without occlusion, divided by the density of the place on the light; partial
                     ///< coverage counts by its mean
    double density;  ///< of `towards` per solid angle; 0 for lights without area, which no ray hits
};

/// Returns the place of `light` for a point of the unit square, uniform over its area or, with a texture, in
/// proportion to brightness. Returns nothing if the light does not reach the receiver from there.
[[nodiscard]] std::optional<LightSample> sample_light(const RayScene& rays, const Light& light,
                                                      const Receiver& receiver,
                                                      const std::array<double, 2>& square);

/// Returns the density per solid angle with which sample_light() picks `place` of `light`. `towards` leads
/// from the receiver to the place.
[[nodiscard]] double density_of(const AreaLight& light, const SurfaceId& place, const Vec3& towards);

}  // namespace common::reference
