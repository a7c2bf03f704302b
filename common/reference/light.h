// The kinds of light that a point of a surface can be joined to by a straight line.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "common/tracer/ray_scene.h"

namespace common::reference {

/// A point that light arrives at.
struct Receiver {
    Vec3 origin;            ///< off the surface, on the side that gathers
    Vec3 normal;            ///< unit: what the cosine of incidence is taken with
    Vec3 geometric_normal;  ///< unit: light from behind it does not arrive
};

/// A triangle that emits with a cosine lobe, from its front or from both faces.
struct AreaLight {
    std::uint32_t triangle;
    bool both_faces;
    double area;
    double mean_radiance;  ///< over triangle and channels, never 0: only chooses the light
    std::array<Imath::V3d, 3> corner;
    Imath::V3d normal;  ///< unit, out of the front face
};

[[nodiscard]] AreaLight area_light(const Scene& scene, std::uint32_t triangle);

using Light = std::variant<AreaLight, PointLight, SpotLight, DirectionalLight>;

/// Total flux, W, mean over the channels. A directional light's goes through a disc of radius `scene_radius`.
[[nodiscard]] double power_of(const Light& light, double scene_radius);

/// A guess at the irradiance that the light brings to the receiver if nothing is between them, W/m^2, mean
/// over the channels: 0 only where it brings none.
[[nodiscard]] double expected_irradiance(const Light& light, const Receiver& receiver);

/// A place on a light as a receiver sees it.
struct LightSample {
    Vec3 towards;    ///< from the receiver's origin to the place; for directional lights unit
    float reach;     ///< where the light is, in lengths of `towards`: 1, or infinity
    Rgb irradiance;  ///< W/m^2 if nothing is between, divided by the density of the place on the light
    double density;  ///< of `towards` per solid angle; 0 for lights without area, which no ray meets
};

/// The place of `light` that belongs to a point of the unit square, uniform over its area; nothing where it
/// does not shine on the receiver from there.
[[nodiscard]] std::optional<LightSample> sample_light(const RayScene& rays, const Light& light,
                                                      const Receiver& receiver,
                                                      const std::array<double, 2>& square);

/// Density per solid angle with which sample_light picks the place of `light` that lies `towards` the
/// receiver.
[[nodiscard]] double density_of(const AreaLight& light, const Vec3& towards);

}  // namespace common::reference
