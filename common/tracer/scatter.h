// What a surface does with a photon that arrives on it.
#pragma once

#include <array>
#include <optional>

#include "common/core/sampling.h"
#include "common/scene/surface_point.h"

namespace common {

/// One roulette over `reflected` = flux times reflectance: the photon survives with the reflected fraction of
/// its brightest channel and keeps that channel's flux, so that every channel is right on average and no
/// photon grows.
struct Roulette {
    bool survived;
    Rgb flux;  ///< of a survivor
};

[[nodiscard]] inline Roulette play_roulette(const Rgb& flux, const Rgb& reflected, float u) {
    const float before = max_component(flux), after = max_component(reflected);
    return {u * before < after, reflected * (before / after)};
}

/// Unit direction of a Lambertian reflection to the side of `normal` (unit).
[[nodiscard]] inline Vec3 reflect_diffusely(const Vec3& normal, float u1, float u2) {
    return Frame(normal).to_world(sample_cosine_hemisphere(u1, u2));
}

struct ScatteredPhoton {
    Vec3 direction;  ///< unit, away from the surface
    Vec3 normal;     ///< unit geometric normal, on the side that the photon leaves to
    Rgb flux;        ///< W times the number emitted, Russian roulette accounted for
};

/// Reflects, lets through or absorbs (nothing returned) a photon that travels along `direction` with `flux`.
///
/// Where the surface is there in part only, chance decides whether the photon meets it or goes straight on,
/// with all of its flux. Absorption is Russian roulette. Diffuse surfaces reflect on both faces around the
/// geometric normal: a normal map bends what is gathered, not the light's way, which keeps the scene's
/// energy. `u` holds uniform numbers: [0] roulette, [1], [2] direction, [3] hole or not, then whether a
/// boundary reflects or lets through.
[[nodiscard]] std::optional<ScatteredPhoton> scatter(const Scene& scene, const SurfaceId& surface,
                                                     const Vec3& direction, const Rgb& flux,
                                                     const std::array<float, 4>& u);

/// Fraction of unpolarised light that a smooth boundary reflects (Fresnel). `cos_incident` > 0; `eta` is the
/// index of the side that the light comes from over that of the other.
[[nodiscard]] float fresnel_reflectance(float cos_incident, float eta);

/// The same of a sheet without thickness: two boundaries, and all reflections between them. `index` is that
/// of what it is made of.
[[nodiscard]] float sheet_reflectance(float cos_incident, float index);

/// Where a perfect mirror or smooth glass sends what travels along `direction` (unit, towards the surface).
struct SpecularDirections {
    Vec3 reflected;              ///< unit, away from the side of arrival
    std::optional<Vec3> passed;  ///< unit, into the other side: refracted, or as it came through a thin
                                 ///< sheet; none for mirrors and at total reflection
    float reflectance = 1;       ///< of glass; 1 where nothing passes
};

/// Specular surfaces follow the smooth vertex normal, so that a faceted sphere focuses like a round one,
/// except where that would send light through the wrong side of the triangle.
[[nodiscard]] SpecularDirections specular_directions(const Scene& scene, const SurfaceId& surface,
                                                     const Vec3& direction);

/// `direction` mirrored at a surface with unit `normal`; both senses of the normal do.
[[nodiscard]] inline Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    return direction - normal * (2 * direction.dot(normal));
}

/// `direction` bent at a boundary (Snell), or nothing where it is totally reflected. `normal` is unit and
/// faces against `direction`; `eta` as in fresnel_reflectance.
[[nodiscard]] std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, float eta);

}  // namespace common
