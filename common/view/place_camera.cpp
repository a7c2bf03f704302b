#include "common/view/place_camera.h"

#include "common/core/input_error.h"
#include "common/view/camera_rays.h"

namespace common {
namespace {

constexpr float automatic_fov = 1.0471976f;  // 60 degrees

/// Viewpoints as fractions of the half extents around the bounds' centre: towards the corners and sides of a
/// box, at two heights, inside and out.
std::vector<Vec3> viewpoints(const Imath::Box3f& bounds) {
    std::vector<Vec3> eyes;
    const Vec3 center = bounds.center(), half = bounds.size() * 0.5f;
    const float outside = 1.2f * half.length();
    for (float height : {0.1f, 0.5f})
        for (int x = -1; x <= 1; ++x)
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && z == 0) continue;
                const Vec3 towards(static_cast<float>(x), height, static_cast<float>(z));
                eyes.push_back(center + half * towards * 0.8f);
                eyes.push_back(center + towards.normalized() * outside * 1.5f);
            }
    return eyes;
}

/// Rates a camera by a small image: the fraction of pixels with front faces, times their mean distance (a
/// wall right before the eye shows nothing). Distances are clamped at the scene's size.
double score(const RayScene& rays, const Camera& camera) {
    constexpr int width = 32, height = 18;
    const Scene& scene = rays.scene();
    const CameraRays view(camera, width, height);
    double seen = 0, distance = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3 direction = view.direction(x, y);
            const auto surface = rays.nearest(camera.eye, direction);
            if (!surface) continue;
            const bool front = direction.dot(scene.geometric_normal[surface->triangle]) < 0;
            if (!front && !scene.material_of(surface->triangle).double_sided) continue;
            seen += 1;
            distance += std::min(
                1.0f, (position_at(scene, *surface) - camera.eye).length() / (0.5f * scene.diagonal()));
        }
    return seen == 0 ? 0 : seen / (width * height) * (distance / seen);
}

}  // namespace

Camera look_at(const Vec3& eye, const Vec3& target, float vertical_fov) {
    const Vec3 forward = (target - eye).normalized();
    if (forward.length2() == 0) throw InputError("a camera cannot look at the point where it stands");
    const Vec3 vertical = std::abs(forward.y) < 0.999f ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Vec3 up = forward.cross(vertical).cross(forward).normalized();
    return {"", eye, forward, up, vertical_fov};
}

Camera place_camera(const RayScene& rays) {
    const Vec3 center = rays.scene().bounds.center();
    Camera best;
    double best_score = -1;
    for (const Vec3& eye : viewpoints(rays.scene().bounds)) {
        if (eye == center) continue;
        Camera candidate = look_at(eye, center, automatic_fov);
        if (const double s = score(rays, candidate); s > best_score) {
            best = candidate;
            best_score = s;
        }
    }
    best.name = "automatic";
    return best;
}

}  // namespace common
