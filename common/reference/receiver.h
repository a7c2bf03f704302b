// A point that receives light, and its geometry towards lights without size.
#pragma once

#include "common/scene/scene.h"

namespace common::reference {

struct Receiver {
    Vec3 origin;            ///< offset from the surface, on the side that receives light
    Vec3 normal;            ///< unit: the cosine of incidence refers to it
    Vec3 geometric_normal;  ///< unit: light from behind it does not count
};

/// Returns the cosine of incidence of light from the unit direction `towards`; 0 if it comes from behind.
[[nodiscard]] inline double incident_cosine(const Receiver& receiver, const Imath::V3d& towards) {
    if (Imath::V3d(receiver.geometric_normal).dot(towards) <= 0) return 0;
    return std::max(0.0, Imath::V3d(receiver.normal).dot(towards));
}

/// A light without size as seen from a receiver.
struct PunctualView {
    Imath::V3d towards;              ///< unit
    double cosine_over_distance_sq;  ///< irradiance over intensity; 0 if no light arrives
};

[[nodiscard]] inline PunctualView view_of(const Vec3& position, const Receiver& receiver) {
    const Imath::V3d joining = Imath::V3d(position) - Imath::V3d(receiver.origin);
    const double distance = joining.length();
    if (distance == 0) return {Imath::V3d(0, 0, 0), 0};
    const Imath::V3d towards = joining / distance;
    return {towards, incident_cosine(receiver, towards) / (distance * distance)};
}

/// Returns the factor of a spot's intensity in the unit direction `from_light`: the square of a linear ramp
/// in the cosine (KHR_lights_punctual).
[[nodiscard]] inline double falloff(const SpotLight& light, const Imath::V3d& from_light) {
    const double inner = light.cos_inner_angle, outer = light.cos_outer_angle;
    if (light.is_narrow()) {  // in terms of 1 - cosine, to avoid cancellation
        const double versine = 0.5 * (Imath::V3d(light.axis).normalized() - from_light).length2();
        if (versine <= 1 - inner) return 1;
        if (versine >= 1 - outer) return 0;
        const double ramp = ((1 - outer) - versine) / (inner - outer);
        return ramp * ramp;
    }
    const double cosine = Imath::V3d(light.axis).dot(from_light);
    if (cosine >= inner) return 1;
    if (cosine <= outer) return 0;
    const double ramp = (cosine - outer) / (inner - outer);
    return ramp * ramp;
}

}  // namespace common::reference
