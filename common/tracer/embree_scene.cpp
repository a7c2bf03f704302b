#include "common/tracer/embree_scene.h"

#include <fmt/format.h>

#include <stdexcept>

#include "common/tracer/embree.h"

namespace common {
namespace {

void check(RTCDevice device) {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
        throw std::runtime_error(fmt::format("Embree failed with error {}", static_cast<int>(error)));
}

}  // namespace

void ReleaseEmbree::operator()(RTCDeviceTy* device) const {
    rtcReleaseDevice(device);
}
void ReleaseEmbree::operator()(RTCSceneTy* scene) const {
    rtcReleaseScene(scene);
}

EmbreeDevice start_embree() {
    EmbreeDevice device(rtcNewDevice(nullptr));
    if (!device) throw std::runtime_error("Embree does not start on this machine");
    return device;
}

EmbreeScene make_embree_scene(RTCDeviceTy* device, std::span<const Vec3> position,
                              std::span<const TriangleVertices> triangle, EmbreeFilter filter) {
    EmbreeScene scene(rtcNewScene(device));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);  // rays must not slip through shared edges
    // HIGH quality builds differ from run to run when several threads build.
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);

    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree reads past the last vertex in whole SSE registers, so it gets a padded copy of its own.
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3), position.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(TriangleVertices), triangle.size());
    check(device);
    std::copy(position.begin(), position.end(), static_cast<Vec3*>(vertices));
    std::copy(triangle.begin(), triangle.end(), static_cast<TriangleVertices*>(indices));
    if (filter) rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
    check(device);
    return scene;
}

}  // namespace common
