// The scene's triangles in Embree: nearest surface along a ray, and whether two points see each other.
#pragma once

#include <memory>
#include <optional>

#include "common/scene/surface_point.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace common {

class RayScene {
  public:
    /// Builds Embree's acceleration structure. `scene` must outlive this object.
    explicit RayScene(const Scene& scene);

    /// Nearest surface from `origin` along `direction` (unit), if there is one.
    [[nodiscard]] std::optional<SurfaceId> nearest(const Vec3& origin, const Vec3& direction) const;

    /// Whether a surface lies between `origin` and `origin + direction * reach`. `direction` may have any
    /// length but 0; `reach` may be infinite.
    [[nodiscard]] bool occluded(const Vec3& origin, const Vec3& direction, float reach) const;

    /// `position`, on a surface with unit normal `normal`, moved off it along `normal` by as much as rounding
    /// may have put it on the wrong side: rays that leave towards that side start here.
    [[nodiscard]] Vec3 off_surface(const Vec3& position, const Vec3& normal) const {
        return position + normal * offset_;
    }

    [[nodiscard]] const Scene& scene() const { return *scene_; }

  private:
    struct Release {
        void operator()(RTCDeviceTy* device) const;
        void operator()(RTCSceneTy* scene) const;
    };

    const Scene* scene_;
    float offset_;  ///< world units
    std::unique_ptr<RTCDeviceTy, Release> device_;
    std::unique_ptr<RTCSceneTy, Release> embree_;
};

}  // namespace common
