// Vector and colour types of the whole project: Imath's, under the names used here.
#pragma once

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include <algorithm>
#include <cmath>

namespace common {

using Vec2 = Imath::V2f;
using Vec3 = Imath::V3f;

/// Linear RGB with Rec. 709 primaries. Each use states its unit: W, W/m^2 or W/(m^2 sr) per channel.
using Rgb = Imath::C3f;

inline float max_component(const Rgb& c) {
    return std::max(std::max(c.x, c.y), c.z);
}
inline float mean_component(const Rgb& c) {
    return (c.x + c.y + c.z) * (1.0f / 3.0f);
}

inline bool is_finite(const Vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Returns the value at barycentric coordinates (u, v), as Embree defines them. It must round as the tracer's
/// edges do (PhotonSurface): a colour that differs in its last bit can end a photon's path elsewhere.
template <class T>
T interpolate(const T& a, const T& b, const T& c, float u, float v) {
    return a + (b - a) * u + (c - a) * v;
}

}  // namespace common
