// Scattering of photons at surfaces.
#pragma once

#include <array>
#include <optional>

#include "common/core/sampling.h"
#include "common/scene/surface_point.h"

namespace common {

/// Russian roulette over `reflected` = flux times reflectance. The photon survives with the reflected
/// fraction of its brightest channel and keeps that channel's flux. So every channel is unbiased, and no
/// photon gains flux.
struct Roulette {
    bool survived;
    Rgb flux;  ///< of a survivor
};

[[nodiscard]] inline Roulette play_roulette(const Rgb& flux, const Rgb& reflected, float u) {
    const float before = max_component(flux), after = max_component(reflected);
    return {u * before < after, reflected * (before / after)};
}

/// Returns the unit direction of a Lambertian reflection to the side of `normal` (unit).
[[nodiscard]] inline Vec3 reflect_diffusely(const Vec3& normal, float u1, float u2) {
    return Frame(normal).to_world(sample_cosine_hemisphere(u1, u2));
}

struct ScatteredPhoton {
    Vec3 direction;         ///< unit, away from the surface
    Vec3 normal;            ///< unit geometric normal, on the side that the photon leaves to
    Rgb flux;               ///< W times the number emitted, after Russian roulette
    bool straight = false;  ///< through a hole or a thin sheet, as if it were not there
};

/// Reflects, transmits or absorbs (returns nothing) a photon that travels along `direction` with `flux`.
///
/// With partial coverage, chance decides whether the photon hits the surface or goes straight on with all of
/// its flux. Absorption is Russian roulette. Diffuse surfaces reflect on both faces about the geometric
/// normal. A normal map affects only the gathered irradiance, not the direction of light, which conserves the
/// scene's energy. `u` holds uniform numbers: [0] roulette, [1], [2] direction, [3] coverage, then reflection
/// or transmission at a boundary.
[[nodiscard]] std::optional<ScatteredPhoton> scatter(const Scene& scene, const SurfaceId& surface,
                                                     const Vec3& direction, const Rgb& flux,
                                                     const std::array<float, 4>& u);

/// Returns the fraction of unpolarised light that a smooth boundary reflects (Fresnel). `cos_incident` > 0;
/// `eta` is the index of the side that the light comes from over that of the other.
[[nodiscard]] float fresnel_reflectance(float cos_incident, float eta);

/// Returns the same for a sheet without thickness: two boundaries with all reflections between them. `index`
/// is that of its material.
[[nodiscard]] float sheet_reflectance(float cos_incident, float index);

/// The directions in which a perfect mirror or smooth glass sends light that arrives along `direction` (unit,
/// towards the surface).
struct SpecularDirections {
    Vec3 reflected;              ///< unit, back to the side of arrival
    std::optional<Vec3> passed;  ///< unit, into the other side: refracted, or straight on through a thin
                                 ///< sheet; none for mirrors and at total reflection
    float reflectance = 1;       ///< of glass; 1 if nothing passes
};

/// Returns the directions about the smooth vertex normal, so that a faceted sphere focuses like a round one,
/// except where that would send light through the wrong side of the triangle.
[[nodiscard]] SpecularDirections specular_directions(const Scene& scene, const SurfaceId& surface,
                                                     const Vec3& direction);

/// Returns `direction` mirrored at a surface with unit `normal`, which may point to either side.
[[nodiscard]] inline Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    return direction - normal * (2 * direction.dot(normal));
}

/// Returns `direction` refracted at a boundary (Snell), or nothing at total reflection. `normal` is unit and
/// faces against `direction`; `eta` as in fresnel_reflectance().
[[nodiscard]] std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, float eta);

}  // namespace common
