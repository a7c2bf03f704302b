#include "common/view/camera_rays.h"

namespace common {

CameraRays::CameraRays(const Camera& camera, int width, int height) : width_(width), height_(height) {
    const float half_height = std::tan(0.5f * camera.vertical_fov);
    const float half_width = half_height * static_cast<float>(width) / static_cast<float>(height);
    forward_ = camera.forward;
    right_ = camera.forward.cross(camera.up).normalized() * half_width;
    up_ = camera.up * half_height;
}

Vec3 CameraRays::direction(int x, int y) const {
    const float across = 2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(width_) - 1;
    const float down = 2 * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_) - 1;
    return (forward_ + right_ * across - up_ * down).normalized();
}

}  // namespace common
