#include "common/reference/expected_light.h"

namespace common::reference {
namespace {

using Imath::V3d;

/// Returns the solid angle of a triangle with corners at these vectors (Van Oosterom and Strackee, "The Solid
/// Angle of a Plane Triangle", 1983).
double solid_angle(const V3d& a, const V3d& b, const V3d& c) {
    const double la = a.length(), lb = b.length(), lc = c.length();
    const double volume = std::abs(a.dot(b.cross(c)));
    return 2 * std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Returns the solid angle of the light, never 0; from far away approximated by its centre.
double covered(const AreaLight& light, const V3d& origin, double distance) {
    const double facing = std::abs(light.normal.dot(light.center - origin));
    if (distance > 4 * light.radius) return light.area * facing / (distance * distance * distance);
    constexpr double least_share = 1e-3;  // relative to a light that faces the receiver
    const double farthest = distance + light.radius;
    return std::max(solid_angle(light.corner[0] - origin, light.corner[1] - origin, light.corner[2] - origin),
                    least_share * light.area / (farthest * farthest));
}

double expected(const AreaLight& light, const Receiver& receiver) {
    const V3d origin(receiver.origin);
    const V3d joining = light.center - origin;
    if (!light.both_faces && light.normal.dot(joining) >= 0) return 0;
    const double highest = V3d(receiver.normal).dot(joining) + light.radius;
    if (highest <= 0 || V3d(receiver.geometric_normal).dot(joining) + light.radius <= 0) return 0;
    const double distance = joining.length();
    const double cosine = std::min(1.0, highest / std::max(distance, light.radius));
    return light.mean_radiance * cosine * covered(light, origin, distance);
}
double expected(const PointLight& light, const Receiver& receiver) {
    return mean_channel(light.intensity) * view_of(light.position, receiver).cosine_over_distance_sq;
}
double expected(const SpotLight& light, const Receiver& receiver) {
    const PunctualView view = view_of(light.position, receiver);
    return mean_channel(light.intensity) * falloff(light, -view.towards) * view.cosine_over_distance_sq;
}
double expected(const DirectionalLight& light, const Receiver& receiver) {
    return mean_channel(light.irradiance) * incident_cosine(receiver, -V3d(light.direction));
}

}  // namespace

double expected_irradiance(const Light& light, const Receiver& receiver) {
    return std::visit([&](const auto& l) { return expected(l, receiver); }, light);
}

}  // namespace common::reference
