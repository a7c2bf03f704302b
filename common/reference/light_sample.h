// A place on a light, chosen at random.
#pragma once

#include <optional>

#include "common/reference/light.h"
#include "common/reference/receiver.h"
#include "common/tracer/ray_scene.h"

namespace common::reference {

/// A place on a light as a receiver sees it.
struct LightSample {
    Vec3 towards;    ///< from the receiver's origin to the place; for directional lights unit
    float reach;     ///< where the light is, in lengths of `towards`: 1, or infinity
    Rgb irradiance;  ///< W/m^2 if nothing is between, divided by the density of the place on the light: that
                     ///< of what is there, on average over chance
    double density;  ///< of `towards` per solid angle; 0 for lights without area, which no ray meets
};

/// The place of `light` that belongs to a point of the unit square, uniform over its area or, with a texture,
/// by brightness; nothing where it does not shine on the receiver from there.
[[nodiscard]] std::optional<LightSample> sample_light(const RayScene& rays, const Light& light,
                                                      const Receiver& receiver,
                                                      const std::array<double, 2>& square);

/// Density per solid angle with which sample_light picks `place` of `light`, which lies `towards` the
/// receiver.
[[nodiscard]] double density_of(const AreaLight& light, const SurfaceId& place, const Vec3& towards);

}  // namespace common::reference
