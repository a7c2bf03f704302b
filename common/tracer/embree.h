// Embree 3 (Debian 12) and Embree 4 (Debian 13) behind one call.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <type_traits>

#include "common/core/vector.h"

namespace common {

/// Returns the ray from `origin` to `origin + direction * reach`.
[[nodiscard]] inline RTCRay ray_along(const Vec3& origin, const Vec3& direction, float reach) {
    return {.org_x = origin.x,
            .org_y = origin.y,
            .org_z = origin.z,
            .tnear = 0,
            .dir_x = direction.x,
            .dir_y = direction.y,
            .dir_z = direction.z,
            .time = 0,
            .tfar = reach,
            .mask = ~0u,
            .id = 0,
            .flags = 0};
}

/// Returns the same ray without a hit.
[[nodiscard]] inline RTCRayHit ray_hit_along(const Vec3& origin, const Vec3& direction, float reach) {
    RTCRayHit ray_hit;
    ray_hit.ray = ray_along(origin, direction, reach);
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return ray_hit;
}

/// The context that Embree passes to a filter of the scene. A filter's own data is of a type derived from it.
#if RTC_VERSION_MAJOR >= 4
struct EmbreeContext : RTCRayQueryContext {
    EmbreeContext() { rtcInitRayQueryContext(this); }
};
#else
struct EmbreeContext : RTCIntersectContext {
    EmbreeContext() {
        rtcInitIntersectContext(this);
        flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
};
#endif

/// Finds the nearest hit of one ray among those that the scene's filter accepts.
inline void intersect_incoherent(RTCScene scene, RTCRayHit& ray_hit, EmbreeContext& context) {
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
    arguments.context = &context;
    rtcIntersect1(scene, &ray_hit, &arguments);
#else
    rtcIntersect1(scene, &context, &ray_hit);
#endif
}

/// Finds the nearest hit of one ray whose direction is unrelated to the last one's.
inline void intersect_incoherent(RTCScene scene, RTCRayHit& ray_hit) {
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
    rtcIntersect1(scene, &ray_hit, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcIntersect1(scene, &context, &ray_hit);
#endif
}

/// Whether the rays of a packet have similar directions. It decides how Embree traverses the BVH, not what
/// they hit.
enum class PacketKind { coherent, incoherent };

/// Finds the nearest hits of a packet's rays for which `valid` is -1; it is 0 for the others.
template <class Packet>
void intersect_packet(const int* valid, RTCScene scene, Packet& packet, PacketKind kind) {
    constexpr bool sixteen = std::is_same_v<Packet, RTCRayHit16>;
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags =
        kind == PacketKind::coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    if constexpr (sixteen)
        rtcIntersect16(valid, scene, &packet, &arguments);
    else
        rtcIntersect8(valid, scene, &packet, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = kind == PacketKind::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                 : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    if constexpr (sixteen)
        rtcIntersect16(valid, scene, &context, &packet);
    else
        rtcIntersect8(valid, scene, &context, &packet);
#endif
}

/// Returns whether anything lies along a ray whose direction is unrelated to the last one's.
[[nodiscard]] inline bool occluded_incoherent(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
    rtcOccluded1(scene, &ray, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0;  // Embree's mark of an occluded ray
}

}  // namespace common
