#include "common/view/visible_surfaces.h"

#include <oneapi/tbb/parallel_for.h>

#include "common/core/random.h"
#include "common/scene/coverage.h"
#include "common/tracer/scatter.h"
#include "common/view/camera_rays.h"

namespace common {
namespace {

constexpr int max_specular_events = 32;

/// As for photons, so that a ray through endless holes ends.
constexpr std::uint32_t max_surfaces = 4096;

/// Finds the next surface that a pixel sees, past holes.
class Gaze {
  public:
    Gaze(const RayScene& rays, std::uint64_t pixel) : rays_(rays), pixel_(pixel) {}

    std::optional<SurfaceId> nearest(Vec3 origin, const Vec3& direction) {
        const Scene& scene = rays_.scene();
        while (surfaces_++ < max_surfaces) {
            const auto surface = rays_.nearest(origin, direction);
            if (!surface || is_there(*surface)) return surface;
            const Vec3& front = scene.geometric_normal[surface->triangle];
            origin =
                rays_.off_surface(position_at(scene, *surface), direction.dot(front) < 0 ? -front : front);
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool is_there(const SurfaceId& surface) const {
        const float coverage = coverage_at(rays_.scene(), surface);
        if (coverage == 0 || coverage == 1) return coverage == 1;
        return random_uniforms(0, pixel_, surfaces_, RandomPurpose::looking)[0] < coverage;
    }

    const RayScene& rays_;
    std::uint64_t pixel_;
    std::uint32_t surfaces_ = 0;
};

VisibleSurface look(const RayScene& rays, Vec3 origin, Vec3 direction, std::uint64_t pixel) {
    const Scene& scene = rays.scene();
    Gaze gaze(rays, pixel);
    VisibleSurface seen;
    for (int event = 0; event < max_specular_events; ++event) {
        const auto surface = gaze.nearest(origin, direction);
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
        direction = specular.passed.value_or(specular.reflected);
        const Vec3& normal = seen.point.geometric_normal;
        origin = rays.off_surface(seen.point.position, specular.passed ? -normal : normal);
    }
    return seen;
}

}  // namespace

std::vector<VisibleSurface> visible_surfaces(const RayScene& rays, const Camera& camera, int width,
                                             int height) {
    const CameraRays view(camera, width, height);
    std::vector<VisibleSurface> seen(static_cast<std::size_t>(width) * height);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
            seen[pixel] = look(rays, camera.eye, view.direction(x, y), pixel);
        }
    });
    return seen;
}

}  // namespace common
