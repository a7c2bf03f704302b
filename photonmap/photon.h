// The data of a hit that a photon map keeps beside its position.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/estimator/irradiance_estimator.h"
#include "common/tracer/hit_batch.h"

namespace photonmap {

/// Positions are in a separate array, over which the index is built.
struct Photon {
    common::Vec3 direction;  ///< unit, the way it travelled: towards the surface
    common::Rgb flux;        ///< W times the number emitted; the map scales the sum
    std::uint32_t triangle;  ///< the surface it is on
};

/// Returns the unit normal of the photon's surface on the side of arrival.
[[nodiscard]] inline common::Vec3 arrival_normal(const Photon& photon,
                                                 std::span<const common::Vec3> triangle_normal) {
    const common::Vec3& normal = triangle_normal[photon.triangle];
    return photon.direction.dot(normal) < 0 ? normal : -normal;
}

/// Returns the photon's flux for a shading normal. The ratio of the two cosines of incidence converts
/// irradiance on its own surface to irradiance on a plane with that normal.
[[nodiscard]] inline common::Rgb tilted_flux(const Photon& photon,
                                             std::span<const common::Vec3> triangle_normal,
                                             const common::Vec3& shading_normal) {
    const float on_surface = std::abs(photon.direction.dot(triangle_normal[photon.triangle]));
    const float on_shading = std::max(0.0f, -photon.direction.dot(shading_normal));
    return photon.flux * (on_shading / std::max(on_surface, common::min_incident_cosine));
}

}  // namespace photonmap
