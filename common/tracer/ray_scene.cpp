#include "common/tracer/ray_scene.h"

#include <algorithm>
#include <limits>

#include "common/tracer/embree.h"

namespace common {
namespace {

/// Returns the largest absolute coordinate of the scene, to which its rounding errors are proportional.
float magnitude(const Imath::Box3f& bounds) {
    float largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(bounds.min[axis]), std::abs(bounds.max[axis])});
    return largest;
}

}  // namespace

RayScene::RayScene(const Scene& scene)
    : scene_(&scene),
      surfaces_(scene),
      offset_(magnitude(scene.bounds) * 16 * std::numeric_limits<float>::epsilon()),
      device_(start_embree()),
      embree_(make_embree_scene(device_.get(), scene.position, scene.triangle)) {
    // Rays that leave one of them start well in front of the others.
    const float tolerance = offset_ / 2;
    coinciding_triangles_ = find_coinciding_triangles(scene, tolerance);
    const std::vector<std::uint32_t>& coinciding = coinciding_triangles_.triangle;
    if (coinciding.empty()) return;
    coinciding_ = std::make_unique<const CoincidingSurfaces>(device_.get(), scene, coinciding, tolerance);
    may_cover_lights_ = std::any_of(coinciding.begin(), coinciding.end(),
                                    [&](std::uint32_t t) { return scene.material_of(t).emits(); });
}

std::optional<SurfaceId> RayScene::nearest(const Vec3& origin, const Vec3& direction, float reach) const {
    RTCRayHit ray_hit = ray_hit_along(origin, direction, reach);
    intersect_incoherent(embree_.get(), ray_hit);
    if (ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const SurfaceId found{ray_hit.hit.primID, ray_hit.hit.u, ray_hit.hit.v};
    if (!coincides(found.triangle)) return found;
    return coinciding_->met_at(found, origin, direction, ray_hit.ray.tfar);
}

/// Measured with photons in PhotonOrder, relative to single rays. Coherent packets of 16 are 1.4 to 2 times
/// as fast in scenes of few or evenly spread triangles. They are half as fast among many small triangles,
/// where rays diverge soon. Incoherent packets of 8 are 1.05 to 1.4 times as fast everywhere.
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

/// Traces rays again one by one if they hit an edge or triangles that coincide. Such a ray hits several
/// triangles at the same distance, and in a packet the result depends on the packet.
void RayScene::settle_ties(const Vec3Array& origin, const Vec3Array& direction,
                           NearestSurfaces& found) const {
    constexpr float edge = 1e-6f;  // some ulp of 1
    for (std::size_t i = 0; i < found.u.size(); ++i) {
        const float nearest_edge = std::min({found.u[i], found.v[i], 1 - found.u[i] - found.v[i]});
        if (found.triangle[i] == no_triangle) continue;
        if (nearest_edge > edge && !coincides(found.triangle[i])) continue;
        found.set(i, nearest(origin[i], direction[i]).value_or(no_surface));
    }
}

bool RayScene::is_covered(std::uint32_t triangle, const Vec3& position, const Vec3& normal) const {
    if (!coincides(triangle)) return false;
    const std::optional<SurfaceId> met = nearest(off_surface(position, normal), -normal);
    return met && met->triangle != triangle && coincides(met->triangle);
}

bool RayScene::occluded(const Vec3& origin, const Vec3& direction, float reach) const {
    RTCRay ray = ray_along(origin, direction, reach);
    return occluded_incoherent(embree_.get(), ray);
}

}  // namespace common
