#include "common/reference/straight_line.h"

#include <cmath>

#include "common/reference/path.h"
#include "common/reference/specular.h"
#include "common/scene/coverage.h"

namespace common::reference {
namespace {

using Imath::V3d;

V3d let_through(const Scene& scene, const SurfaceId& surface, const Vec3& leaving) {
    const auto covered = static_cast<double>(coverage_at(scene, surface));
    const double straight = passed_straight(scene, surface, leaving);
    return V3d(1 - covered) + V3d(base_color_at(scene, surface)) * (covered * straight);
}

}  // namespace

bool has_see_through(const Scene& scene) {
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        if (scene.material_of(t).kind == SurfaceKind::thin_sheet || coverage_range(scene, t).has_holes())
            return true;
    return false;
}

V3d part_that_arrives(const RayScene& rays, Vec3 origin, Vec3 direction, float reach) {
    const Scene& scene = rays.scene();
    const bool ends = std::isfinite(reach);
    const Vec3 first_direction = direction, end = ends ? origin + direction * reach : Vec3(0, 0, 0);
    V3d part(1, 1, 1);
    for (int surfaces = 0; surfaces < max_surfaces; ++surfaces) {
        const auto surface = rays.nearest(origin, direction, reach);
        if (!surface) return part;
        part *= let_through(scene, *surface, -direction.normalized());
        if (part == V3d(0, 0, 0)) return part;

        const Vec3& front = scene.geometric_normal[surface->triangle];
        const Vec3 beyond = direction.dot(front) < 0 ? -front : front;
        origin = rays.off_surface(position_at(scene, *surface), beyond);
        if (!ends) continue;
        direction = end - origin;
        reach = 1;
        if (direction.dot(first_direction) <= 0) return part;  // the end lies on the surface, up to rounding
    }
    return V3d(0, 0, 0);
}

}  // namespace common::reference
