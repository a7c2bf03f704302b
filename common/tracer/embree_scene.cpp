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

std::string instruction_set(RTCDeviceTy* device) {
    const auto native = [&](RTCDeviceProperty packets) { return rtcGetDeviceProperty(device, packets) != 0; };
    const int widest = native(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)  ? 16
                       : native(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8
                                                                           : 4;
#if defined(__x86_64__)
    if (widest == 16) return "AVX-512";
    if (widest == 8) return __builtin_cpu_supports("avx2") ? "AVX2" : "AVX";
    return "SSE4.2";
#elif defined(__aarch64__)
    if (widest == 4) return "NEON";
#endif
    return fmt::format("packets of {} rays", widest);
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
