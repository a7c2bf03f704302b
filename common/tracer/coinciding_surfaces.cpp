#include "common/tracer/coinciding_surfaces.h"

#include <limits>

#include "common/scene/coinciding_triangles.h"
#include "common/tracer/embree.h"

namespace common {
namespace {

/// The normals of two triangles in one plane may differ by as much as rounding tilts narrow ones.
constexpr float same_plane_cosine = 0.99f;

bool stops_light(const Scene& scene, const Material& material, const SurfaceId& surface) {
    if (material.kind == SurfaceKind::dielectric || material.kind == SurfaceKind::thin_sheet) return false;
    if (material.alpha_mode == AlphaMode::mask) return alpha_at(scene, surface) >= material.alpha_cutoff;
    return material.alpha_mode == AlphaMode::opaque;
}

/// Returns the priority of a surface: the highest is hit. See CoincidingSurfaces.
int claim_of(const Scene& scene, const SurfaceId& surface, const Vec3& direction) {
    const Material& material = scene.material_of(surface.triangle);
    const bool front = direction.dot(scene.geometric_normal[surface.triangle]) < 0;
    const bool for_this_side = front || is_for_both_faces(material);
    const bool emits_here = material.emits() && (front || material.double_sided);
    return 8 * stops_light(scene, material, surface) + 4 * for_this_side + 2 * emits_here +
           (material.alpha_mode == AlphaMode::opaque);
}

}  // namespace

/// Visits the surfaces that Embree shows it and keeps the best.
struct CoincidingSurfaces::Query : EmbreeContext {
    const CoincidingSurfaces& surfaces;
    SurfaceId found;
    Vec3 position, normal;  ///< of `found`
    Vec3 direction;
    float tolerance;
    SurfaceId best;
    int best_claim = -1;

    Query(const CoincidingSurfaces& those, const SurfaceId& first, const Vec3& along)
        : surfaces(those),
          found(first),
          position(position_at(*those.scene_, first)),
          normal(those.scene_->geometric_normal[first.triangle]),
          direction(along),
          tolerance(1.25f * those.tolerance_),  // positions are rounded
          best(first) {}

    void look_at(const SurfaceId& surface) {
        const Scene& scene = *surfaces.scene_;
        if (std::abs(normal.dot(scene.geometric_normal[surface.triangle])) < same_plane_cosine) return;
        if (std::abs(normal.dot(position_at(scene, surface) - position)) > tolerance) return;
        const int claim = claim_of(scene, surface, direction);
        if (claim < best_claim || (claim == best_claim && surface.triangle > best.triangle)) return;
        best = surface;
        best_claim = claim;
    }
};

CoincidingSurfaces::CoincidingSurfaces(RTCDeviceTy* device, const Scene& scene,
                                       std::span<const std::uint32_t> triangles, float tolerance)
    : scene_(&scene),
      tolerance_(tolerance),
      contains_(scene.triangle.size(), 0),
      triangles_(triangles.begin(), triangles.end()) {
    std::vector<Vec3> position;
    std::vector<TriangleVertices> vertices;
    for (const std::uint32_t t : triangles) {
        contains_[t] = 1;
        const auto first = static_cast<std::uint32_t>(position.size());
        for (const std::uint32_t corner : scene.triangle[t]) position.push_back(scene.position[corner]);
        vertices.push_back({first, first + 1, first + 2});
    }
    embree_ = make_embree_scene(device, position, vertices, show);
}

void CoincidingSurfaces::show(const RTCFilterFunctionNArguments* arguments) {
    const RTCHit hit = rtcGetHitFromHitN(arguments->hit, arguments->N, 0);
    auto& query = *static_cast<Query*>(arguments->context);
    query.look_at({query.surfaces.triangles_[hit.primID], hit.u, hit.v});
    arguments->valid[0] = 0;  // rejects the hit, so that Embree shows the next
}

SurfaceId CoincidingSurfaces::met_at(const SurfaceId& found, const Vec3& origin, const Vec3& direction,
                                     float distance) const {
    Query query(*this, found, direction);
    // Distances have relative rounding errors.
    constexpr float rounding = 8 * std::numeric_limits<float>::epsilon();
    const float cosine = std::abs(direction.dot(query.normal));
    const float reach = (query.tolerance + rounding * distance) / std::max(cosine, 1e-6f);
    RTCRayHit ray_hit = ray_hit_along(origin, direction, distance + reach);
    ray_hit.ray.tnear = std::max(0.0f, distance - reach);
    intersect_incoherent(embree_.get(), ray_hit, query);
    return query.best;
}

}  // namespace common
