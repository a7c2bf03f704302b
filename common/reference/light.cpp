#include "common/reference/light.h"

#include <limits>
#include <numbers>

namespace common::reference {
namespace {

using Imath::V3d;
using std::numbers::pi;

constexpr float infinity = std::numeric_limits<float>::infinity();

double mean_of(const Rgb& c) {
    return (static_cast<double>(c.x) + static_cast<double>(c.y) + static_cast<double>(c.z)) / 3;
}

/// Barycentric coordinates, uniform over a triangle: the square's far half is folded onto the near one.
SurfaceId folded(std::uint32_t triangle, const std::array<double, 2>& square) {
    const bool beyond = square[0] + square[1] > 1;
    const double u = beyond ? 1 - square[0] : square[0], v = beyond ? 1 - square[1] : square[1];
    return {triangle, static_cast<float>(u), static_cast<float>(v)};
}

/// Cosine of incidence of light from the unit direction `towards`; 0 where it comes from behind.
double incident_cosine(const Receiver& receiver, const V3d& towards) {
    if (V3d(receiver.geometric_normal).dot(towards) <= 0) return 0;
    return std::max(0.0, V3d(receiver.normal).dot(towards));
}

/// Factor of a spot's intensity in the unit direction `from_light`: the square of a linear ramp in the cosine
/// (KHR_lights_punctual).
double falloff(const SpotLight& light, const V3d& from_light) {
    const double cosine = V3d(light.axis).dot(from_light);
    const double inner = static_cast<double>(light.cos_inner_angle);
    const double outer = static_cast<double>(light.cos_outer_angle);
    if (cosine >= inner) return 1;
    if (cosine <= outer) return 0;
    const double ramp = (cosine - outer) / (inner - outer);
    return ramp * ramp;
}

/// Intensity over distance squared, which a cosine turns into irradiance.
struct PunctualView {
    V3d towards;  ///< unit
    double distance;
    double cosine_over_distance_sq;
};

PunctualView view_of(const Vec3& position, const Receiver& receiver) {
    const V3d joining = V3d(position) - V3d(receiver.origin);
    const double distance = joining.length();
    if (distance == 0) return {V3d(0, 0, 0), 0, 0};
    const V3d towards = joining / distance;
    return {towards, distance, incident_cosine(receiver, towards) / (distance * distance)};
}

// --- power

double power(const AreaLight& light, double) {
    return light.mean_radiance * pi * light.area * (light.both_faces ? 2 : 1);
}
double power(const PointLight& light, double) {
    return 4 * pi * mean_of(light.intensity);
}
/// The falloff integrates to 2 pi (1 - inner + (inner - outer) / 3) over directions.
double power(const SpotLight& light, double) {
    const double inner = static_cast<double>(light.cos_inner_angle);
    const double outer = static_cast<double>(light.cos_outer_angle);
    return 2 * pi * mean_of(light.intensity) * (1 - inner + (inner - outer) / 3);
}
double power(const DirectionalLight& light, double scene_radius) {
    return mean_of(light.irradiance) * pi * scene_radius * scene_radius;
}

// --- expected irradiance

/// Solid angle of a triangle with corners at these vectors (Van Oosterom and Strackee, "The Solid Angle of a
/// Plane Triangle", 1983).
double solid_angle(const V3d& a, const V3d& b, const V3d& c) {
    const double la = a.length(), lb = b.length(), lc = c.length();
    const double volume = std::abs(a.dot(b.cross(c)));
    return 2 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double expected(const AreaLight& light, const Receiver& receiver) {
    const V3d origin(receiver.origin);
    if (!light.both_faces && light.normal.dot(origin - light.corner[0]) <= 0) return 0;
    double highest = 0, highest_geometric = 0, farthest_sq = 0;
    for (const V3d& corner : light.corner) {
        const V3d joining = corner - origin;
        highest = std::max(highest, V3d(receiver.normal).dot(joining.normalized()));
        highest_geometric = std::max(highest_geometric, V3d(receiver.geometric_normal).dot(joining));
        farthest_sq = std::max(farthest_sq, joining.length2());
    }
    // A triangle is below the horizon where all its corners are.
    if (highest <= 0 || highest_geometric <= 0) return 0;
    constexpr double least_share = 0.01;  // of the light seen face on: keeps rounding from ruling out a light
    const double seen =
        solid_angle(light.corner[0] - origin, light.corner[1] - origin, light.corner[2] - origin);
    return light.mean_radiance *
           (seen * std::max(highest, 0.1) + least_share * highest * light.area / farthest_sq);
}
double expected(const PointLight& light, const Receiver& receiver) {
    return mean_of(light.intensity) * view_of(light.position, receiver).cosine_over_distance_sq;
}
double expected(const SpotLight& light, const Receiver& receiver) {
    const PunctualView view = view_of(light.position, receiver);
    return mean_of(light.intensity) * falloff(light, -view.towards) * view.cosine_over_distance_sq;
}
double expected(const DirectionalLight& light, const Receiver& receiver) {
    return mean_of(light.irradiance) * incident_cosine(receiver, -V3d(light.direction));
}

// --- samples

using Square = std::array<double, 2>;
using MaybeSample = std::optional<LightSample>;

MaybeSample sample(const RayScene& rays, const AreaLight& light, const Receiver& receiver,
                   const Square& square) {
    const Scene& scene = rays.scene();
    const SurfaceId place = folded(light.triangle, square);
    const Vec3& front = scene.geometric_normal[light.triangle];
    const Vec3 position = position_at(scene, place);
    const bool from_front = front.dot(receiver.origin - position) > 0;
    if (!from_front && !light.both_faces) return std::nullopt;
    const Vec3 towards = rays.off_surface(position, from_front ? front : -front) - receiver.origin;
    const double cosine = incident_cosine(receiver, V3d(towards).normalized());
    const double density = density_of(light, towards);
    if (cosine <= 0 || !(density > 0)) return std::nullopt;
    return LightSample{towards, 1, emitted_radiance_at(scene, place) * static_cast<float>(cosine / density),
                       density};
}

MaybeSample punctual_sample(const Vec3& position, const Receiver& receiver, const PunctualView& view,
                            const Rgb& intensity) {
    if (!(view.cosine_over_distance_sq > 0)) return std::nullopt;
    return LightSample{position - receiver.origin, 1,
                       intensity * static_cast<float>(view.cosine_over_distance_sq), 0};
}

MaybeSample sample(const RayScene&, const PointLight& light, const Receiver& receiver, const Square&) {
    return punctual_sample(light.position, receiver, view_of(light.position, receiver), light.intensity);
}
MaybeSample sample(const RayScene&, const SpotLight& light, const Receiver& receiver, const Square&) {
    const PunctualView view = view_of(light.position, receiver);
    return punctual_sample(light.position, receiver, view,
                           light.intensity * static_cast<float>(falloff(light, -view.towards)));
}
MaybeSample sample(const RayScene&, const DirectionalLight& light, const Receiver& receiver, const Square&) {
    const double cosine = incident_cosine(receiver, -V3d(light.direction));
    if (cosine <= 0) return std::nullopt;
    return LightSample{-light.direction, infinity, light.irradiance * static_cast<float>(cosine), 0};
}

/// Mean over a grid, and at least a hundredth of the untextured radiance: the grid may miss what is bright.
double mean_radiance(const Scene& scene, std::uint32_t triangle) {
    const Material& material = scene.material_of(triangle);
    const double untextured = mean_of(material.emitted_radiance);
    if (material.emissive_texture.texture == no_texture) return untextured;
    constexpr int across = 12;
    double sum = 0;
    for (int i = 0; i < across * across; ++i)
        sum += mean_of(emitted_radiance_at(
            scene, folded(triangle, {(i % across + 0.5) / across, (i / across + 0.5) / across})));
    return std::max(sum / (across * across), 0.01 * untextured);
}

}  // namespace

AreaLight area_light(const Scene& scene, std::uint32_t triangle) {
    const auto [a, b, c] = scene.triangle[triangle];
    const std::array<V3d, 3> corner = {V3d(scene.position[a]), V3d(scene.position[b]),
                                       V3d(scene.position[c])};
    const V3d twice_area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    return {triangle,
            scene.material_of(triangle).double_sided,
            0.5 * twice_area.length(),
            mean_radiance(scene, triangle),
            corner,
            V3d(scene.geometric_normal[triangle])};
}

double power_of(const Light& light, double scene_radius) {
    return std::visit([&](const auto& l) { return power(l, scene_radius); }, light);
}

double expected_irradiance(const Light& light, const Receiver& receiver) {
    return std::visit([&](const auto& l) { return expected(l, receiver); }, light);
}

std::optional<LightSample> sample_light(const RayScene& rays, const Light& light, const Receiver& receiver,
                                        const Square& square) {
    return std::visit([&](const auto& l) { return sample(rays, l, receiver, square); }, light);
}

double density_of(const AreaLight& light, const Vec3& towards) {
    const V3d joining(towards);
    const double distance_sq = joining.length2();
    const double cosine = std::abs(light.normal.dot(joining)) / std::sqrt(distance_sq);
    return cosine > 0 ? distance_sq / (light.area * cosine) : 0;
}

}  // namespace common::reference
