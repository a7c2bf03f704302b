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
      surfaces_(scene),
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

std::optional<SurfaceId> RayScene::nearest(const Vec3& origin, const Vec3& direction, float reach) const {
    RTCRayHit ray_hit;
    ray_hit.ray = ray_along(origin, direction, reach);
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect_incoherent(embree_.get(), ray_hit);
    if (ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return SurfaceId{ray_hit.hit.primID, ray_hit.hit.u, ray_hit.hit.v};
}

/// Measured with photons in PhotonOrder, against single rays: packets of 16 that stay together are 1.4 to 2
/// times as fast in scenes of few or evenly spread triangles, and half as fast among many small ones, where
/// each ray goes its own way soon; packets of 8 that may fall apart are 1.05 to 1.4 times as fast everywhere.
constexpr std::size_t most_triangles_for_coherent_packets = 50'000;

void RayScene::nearest(const Vec3Array& origin, const Vec3Array& direction, NearestSurfaces& found) const {
    found.resize(origin.x.size());
    if (scene_->triangle.size() <= most_triangles_for_coherent_packets)
        nearest_in_packets<16>(origin, direction, found);
    else
        nearest_in_packets<8>(origin, direction, found);
}

template <int Rays>
void RayScene::nearest_in_packets(const Vec3Array& origin, const Vec3Array& direction,
                                  NearestSurfaces& found) const {
    using Packet = std::conditional_t<Rays == 16, RTCRayHit16, RTCRayHit8>;
    constexpr PacketKind kind = Rays == 16 ? PacketKind::coherent : PacketKind::incoherent;
    const std::size_t count = origin.x.size();
    Packet packet;
    alignas(64) int valid[Rays];
    for (int k = 0; k < Rays; ++k) {
        packet.ray.tnear[k] = 0;
        packet.ray.time[k] = 0;
        packet.ray.mask[k] = ~0u;
        packet.ray.id[k] = 0;
        packet.ray.flags[k] = 0;
    }
    for (std::size_t first = 0; first < count; first += Rays) {
        const std::size_t rays = std::min<std::size_t>(Rays, count - first);
        for (std::size_t k = 0; k < Rays; ++k) {
            const std::size_t i = first + std::min(k, rays - 1);
            packet.ray.org_x[k] = origin.x[i];
            packet.ray.org_y[k] = origin.y[i];
            packet.ray.org_z[k] = origin.z[i];
            packet.ray.dir_x[k] = direction.x[i];
            packet.ray.dir_y[k] = direction.y[i];
            packet.ray.dir_z[k] = direction.z[i];
            packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
            packet.hit.primID[k] = no_triangle;
            packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
            valid[k] = k < rays ? -1 : 0;
        }
        intersect_packet(valid, embree_.get(), packet, kind);
        std::copy_n(packet.hit.primID, rays, &found.triangle[first]);
        std::copy_n(packet.hit.u, rays, &found.u[first]);
        std::copy_n(packet.hit.v, rays, &found.v[first]);
    }
    settle_ties(origin, direction, found);
}

/// A ray that meets an edge hits two triangles at the same distance, and which of them is found depends on
/// the packet. One by one it does not.
void RayScene::settle_ties(const Vec3Array& origin, const Vec3Array& direction,
                           NearestSurfaces& found) const {
    constexpr float edge = 1e-6f;  // some ulp of 1
    for (std::size_t i = 0; i < found.u.size(); ++i) {
        const float nearest_edge = std::min({found.u[i], found.v[i], 1 - found.u[i] - found.v[i]});
        if (nearest_edge > edge || found.triangle[i] == no_triangle) continue;
        found.set(i, nearest(origin[i], direction[i]).value_or(no_surface));
    }
}

bool RayScene::occluded(const Vec3& origin, const Vec3& direction, float reach) const {
    RTCRay ray = ray_along(origin, direction, reach);
    return occluded_incoherent(embree_.get(), ray);
}

}  // namespace common
