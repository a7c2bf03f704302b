#include "common/tracer/scatter.h"

#include "common/scene/coverage.h"

namespace common {

float fresnel_reflectance(float cos_incident, float eta) {
    const float sin_transmitted_sq = eta * eta * (1 - cos_incident * cos_incident);
    if (sin_transmitted_sq >= 1) return 1;
    const float cos_transmitted = std::sqrt(1 - sin_transmitted_sq);
    const float parallel = (cos_incident - eta * cos_transmitted) / (cos_incident + eta * cos_transmitted);
    const float perpendicular =
        (eta * cos_incident - cos_transmitted) / (eta * cos_incident + cos_transmitted);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

float sheet_reflectance(float cos_incident, float index) {
    // Light that enters leaves by a fraction 1 - R at each boundary: R + (1 - R)^2 R (1 + R^2 + R^4 + ...).
    const float once = fresnel_reflectance(cos_incident, 1 / index);
    return 2 * once / (1 + once);
}

std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, float eta) {
    const float cos_incident = -direction.dot(normal);
    const float cos_transmitted_sq = 1 - eta * eta * (1 - cos_incident * cos_incident);
    if (cos_transmitted_sq <= 0) return std::nullopt;
    return (direction * eta + normal * (eta * cos_incident - std::sqrt(cos_transmitted_sq))).normalized();
}

SpecularDirections specular_directions(const Scene& scene, const SurfaceId& surface, const Vec3& direction) {
    const Material& material = scene.material_of(surface.triangle);
    const bool front = direction.dot(scene.geometric_normal[surface.triangle]) < 0;
    const float side = front ? 1.0f : -1.0f;
    const Vec3 normal = scene.geometric_normal[surface.triangle] * side;
    Vec3 smooth = smooth_normal_at(scene, surface) * side;
    if (smooth.dot(direction) >= 0) smooth = normal;

    SpecularDirections directions{reflect(direction, smooth), {}, 1};
    if (directions.reflected.dot(normal) <= 0) directions.reflected = reflect(direction, normal);
    if (material.kind == SurfaceKind::dielectric) {
        const float eta = front ? 1 / material.index_of_refraction : material.index_of_refraction;
        directions.passed = refract(direction, smooth, eta);
        if (directions.passed && directions.passed->dot(normal) >= 0) directions.passed.reset();
        if (directions.passed) directions.reflectance = fresnel_reflectance(-direction.dot(smooth), eta);
    } else if (material.kind == SurfaceKind::thin_sheet) {
        directions.passed = direction;
        directions.reflectance = sheet_reflectance(-direction.dot(smooth), material.index_of_refraction);
    }
    return directions;
}

std::optional<ScatteredPhoton> scatter(const Scene& scene, const SurfaceId& surface, const Vec3& direction,
                                       const Rgb& flux, const std::array<float, 4>& u) {
    const Vec3& front_normal = scene.geometric_normal[surface.triangle];
    const Vec3 normal = direction.dot(front_normal) < 0 ? front_normal : -front_normal;

    const float coverage = coverage_at(scene, surface);
    if (u[3] >= coverage) return ScatteredPhoton{direction, -normal, flux, true};

    const Roulette roulette = play_roulette(flux, flux * base_color_at(scene, surface), u[0]);
    if (!roulette.survived) return std::nullopt;
    if (scene.material_of(surface.triangle).kind == SurfaceKind::diffuse)
        return ScatteredPhoton{reflect_diffusely(normal, u[1], u[2]), normal, roulette.flux};

    const SpecularDirections specular = specular_directions(scene, surface, direction);
    // Below the coverage, u[3] is uniform again.
    if (specular.passed && u[3] >= specular.reflectance * coverage)
        return ScatteredPhoton{*specular.passed, -normal, roulette.flux,
                               scene.material_of(surface.triangle).kind == SurfaceKind::thin_sheet};
    return ScatteredPhoton{specular.reflected, normal, roulette.flux};
}

}  // namespace common
