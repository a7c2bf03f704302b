// Embree 3 (Debian 12) and Embree 4 (Debian 13) behind one call.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace common {

/// Nearest hit of one ray whose direction has nothing to do with the last one's.
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

/// Whether anything lies along a ray whose direction has nothing to do with the last one's.
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
    return ray.tfar < 0;  // Embree's mark
}

}  // namespace common
