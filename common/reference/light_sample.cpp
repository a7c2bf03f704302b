#include "common/reference/light_sample.h"

#include <limits>

#include "common/scene/coverage.h"

namespace common::reference {
namespace {

using Imath::V3d;

constexpr float infinity = std::numeric_limits<float>::infinity();

using Square = std::array<double, 2>;
using MaybeSample = std::optional<LightSample>;

MaybeSample sample(const RayScene& rays, const AreaLight& light, const Receiver& receiver,
                   const Square& square) {
    const Scene& scene = rays.scene();
    const SurfaceId place = place_on(light.triangle, light.places ? light.places->place(square) : square);
    const Vec3& front = scene.geometric_normal[light.triangle];
    const Vec3 position = position_at(scene, place);
    const bool from_front = front.dot(receiver.origin - position) > 0;
    if (!from_front && !light.both_faces) return std::nullopt;
    const Vec3 normal = from_front ? front : -front;
    if (rays.is_covered(light.triangle, position, normal)) return std::nullopt;
    const Vec3 towards = rays.off_surface(position, normal) - receiver.origin;
    const double cosine = incident_cosine(receiver, V3d(towards).normalized());
    const double density = density_of(light, place, towards);
    if (cosine <= 0 || !(density > 0)) return std::nullopt;
    const Rgb radiance = emitted_radiance_at(scene, place) * coverage_at(scene, place);
    return LightSample{towards, 1, radiance * static_cast<float>(cosine / density), density};
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

}  // namespace

std::optional<LightSample> sample_light(const RayScene& rays, const Light& light, const Receiver& receiver,
                                        const Square& square) {
    return std::visit([&](const auto& l) { return sample(rays, l, receiver, square); }, light);
}

double density_of(const AreaLight& light, const SurfaceId& place, const Vec3& towards) {
    const V3d joining(towards);
    const double distance_sq = joining.length2();
    const double cosine = std::abs(light.normal.dot(joining)) / std::sqrt(distance_sq);
    if (!(cosine > 0)) return 0;
    const double uniform = distance_sq / (light.area * cosine);
    if (!light.places) return uniform;
    // The square is folded: a place of the triangle belongs to one point in each half.
    const double u = static_cast<double>(place.u), v = static_cast<double>(place.v);
    return uniform * 0.5 * (light.places->density({u, v}) + light.places->density({1 - u, 1 - v}));
}

}  // namespace common::reference
