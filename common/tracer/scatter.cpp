#include "common/tracer/scatter.h"

#include "common/core/sampling.h"

namespace common {
namespace {

/// What is left of `flux` after one roulette over `reflected` = flux times reflectance.
std::optional<Rgb> survive(const Rgb& flux, const Rgb& reflected, float u) {
    const float before = max_component(flux), after = max_component(reflected);
    if (!(u * before < after)) return std::nullopt;
    return reflected * (before / after);
}

}  // namespace

float fresnel_reflectance(float cos_incident, float eta) {
    const float sin_transmitted_sq = eta * eta * (1 - cos_incident * cos_incident);
    if (sin_transmitted_sq >= 1) return 1;
    const float cos_transmitted = std::sqrt(1 - sin_transmitted_sq);
    const float parallel = (cos_incident - eta * cos_transmitted) / (cos_incident + eta * cos_transmitted);
    const float perpendicular =
        (eta * cos_incident - cos_transmitted) / (eta * cos_incident + cos_transmitted);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, float eta) {
    const float cos_incident = -direction.dot(normal);
    const float cos_transmitted_sq = 1 - eta * eta * (1 - cos_incident * cos_incident);
    if (cos_transmitted_sq <= 0) return std::nullopt;
    return (direction * eta + normal * (eta * cos_incident - std::sqrt(cos_transmitted_sq))).normalized();
}

std::optional<ScatteredPhoton> scatter(const Scene& scene, const SurfaceId& surface, const Vec3& direction,
                                       const Rgb& flux, const std::array<float, 4>& u) {
    const Material& material = scene.material_of(surface.triangle);
    const Vec3& front_normal = scene.geometric_normal[surface.triangle];
    const bool front = direction.dot(front_normal) < 0;
    const Vec3 normal = front ? front_normal : -front_normal;

    const std::optional<Rgb> survived = survive(flux, flux * base_color_at(scene, surface), u[0]);
    if (!survived) return std::nullopt;

    if (material.kind == SurfaceKind::diffuse)
        return ScatteredPhoton{Frame(normal).to_world(sample_cosine_hemisphere(u[1], u[2])), normal,
                               *survived};

    // Specular surfaces follow the smooth normal, so that a faceted sphere focuses like a round one, unless
    // that would send the photon through the wrong side.
    Vec3 smooth = smooth_normal_at(scene, surface) * (front ? 1.0f : -1.0f);
    if (smooth.dot(direction) >= 0) smooth = normal;

    if (material.kind == SurfaceKind::dielectric) {
        const float eta = front ? 1 / material.index_of_refraction : material.index_of_refraction;
        if (u[3] >= fresnel_reflectance(-direction.dot(smooth), eta)) {
            const std::optional<Vec3> refracted = refract(direction, smooth, eta);
            if (refracted && refracted->dot(normal) < 0)
                return ScatteredPhoton{*refracted, -normal, *survived};
        }
    }
    Vec3 reflected = reflect(direction, smooth);
    if (reflected.dot(normal) <= 0) reflected = reflect(direction, normal);
    return ScatteredPhoton{reflected, normal, *survived};
}

}  // namespace common
