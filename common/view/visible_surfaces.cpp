#include "common/view/visible_surfaces.h"

#include <oneapi/tbb/parallel_for.h>

#include "common/tracer/scatter.h"
#include "common/view/camera_rays.h"

namespace common {
namespace {

constexpr int max_specular_events = 32;

VisibleSurface look(const RayScene& rays, Vec3 origin, Vec3 direction) {
    const Scene& scene = rays.scene();
    VisibleSurface seen;
    for (int event = 0; event < max_specular_events; ++event) {
        const auto surface = rays.nearest(origin, direction);
        if (!surface) {
            if (scene.sky) seen.emitted = scene.sky->radiance;
            return seen;
        }
        const Material& material = scene.material_of(surface->triangle);
        seen.point = surface_point_at(scene, *surface, direction);
        if (material.kind == SurfaceKind::diffuse) {
            seen.present = true;
            seen.reflectance = base_color_at(scene, *surface);
            if (seen.point.front || material.double_sided)
                seen.emitted = emitted_radiance_at(scene, *surface);
            return seen;
        }
        seen.throughput *= base_color_at(scene, *surface);
        const SpecularDirections specular = specular_directions(scene, *surface, direction);
        direction = specular.refracted.value_or(specular.reflected);
        const Vec3& normal = seen.point.geometric_normal;
        origin = rays.off_surface(seen.point.position, specular.refracted ? -normal : normal);
    }
    return seen;
}

}  // namespace

std::vector<VisibleSurface> visible_surfaces(const RayScene& rays, const Camera& camera, int width,
                                             int height) {
    const CameraRays view(camera, width, height);
    std::vector<VisibleSurface> seen(static_cast<std::size_t>(width) * height);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x)
            seen[static_cast<std::size_t>(y) * width + x] = look(rays, camera.eye, view.direction(x, y));
    });
    return seen;
}

}  // namespace common
