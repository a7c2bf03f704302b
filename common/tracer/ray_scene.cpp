#include "common/tracer/ray_scene.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "common/tracer/embree.h"

namespace common {
namespace {

/// Largest coordinate of the scene: what its rounding errors are proportional to.
float magnitude(const Imath::Box3f& bounds) {
    float largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(bounds.min[axis]), std::abs(bounds.max[axis])});
    return largest;
}

void check(RTCDevice device) {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
        throw std::runtime_error(fmt::format("Embree failed with error {}", static_cast<int>(error)));
}

RTCRay ray_along(const Vec3& origin, const Vec3& direction, float reach) {
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

}  // namespace

void RayScene::Release::operator()(RTCDeviceTy* device) const {
    rtcReleaseDevice(device);
}
void RayScene::Release::operator()(RTCSceneTy* scene) const {
    rtcReleaseScene(scene);
}

RayScene::RayScene(const Scene& scene)
    : scene_(&scene),
      offset_(magnitude(scene.bounds) * 16 * std::numeric_limits<float>::epsilon()),
      device_(rtcNewDevice(nullptr)) {
    if (!device_) throw std::runtime_error("Embree does not start on this machine");
    embree_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(embree_.get(), RTC_SCENE_FLAG_ROBUST);  // rays must not slip through shared edges
    // HIGH quality builds differ from run to run when several threads build.
    rtcSetSceneBuildQuality(embree_.get(), RTC_BUILD_QUALITY_MEDIUM);

    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree reads past the last vertex in whole SSE registers, so it gets a padded copy of its own.
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3), scene.position.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(TriangleVertices), scene.triangle.size());
    check(device_.get());
    std::copy(scene.position.begin(), scene.position.end(), static_cast<Vec3*>(vertices));
    std::copy(scene.triangle.begin(), scene.triangle.end(), static_cast<TriangleVertices*>(indices));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(embree_.get());
    check(device_.get());
}

std::optional<SurfaceId> RayScene::nearest(const Vec3& origin, const Vec3& direction) const {
    RTCRayHit ray_hit;
    ray_hit.ray = ray_along(origin, direction, std::numeric_limits<float>::infinity());
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect_incoherent(embree_.get(), ray_hit);
    if (ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return SurfaceId{ray_hit.hit.primID, ray_hit.hit.u, ray_hit.hit.v};
}

bool RayScene::occluded(const Vec3& origin, const Vec3& direction, float reach) const {
    RTCRay ray = ray_along(origin, direction, reach);
    return occluded_incoherent(embree_.get(), ray);
}

}  // namespace common
