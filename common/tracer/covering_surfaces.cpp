#include "common/tracer/covering_surfaces.h"

#include <limits>

namespace common {

float CoveringSurfaces::height_over(const SurfacePoint& point) const {
    const Vec3& up = point.geometric_normal;
    const std::optional<SurfaceId> found = rays_->nearest(rays_->off_surface(point.position, up), up);
    if (!found || pieces_.of_triangle(found->triangle) == pieces_.of_triangle(point.surface.triangle))
        return std::numeric_limits<float>::infinity();
    return (position_at(rays_->scene(), *found) - point.position).dot(up);
}

}  // namespace common
