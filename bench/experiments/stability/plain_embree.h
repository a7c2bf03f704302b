// Embree without its robust flag, which keeps rays from slipping through shared edges: for comparison.
#pragma once

#include <limits>
#include <memory>

#include "common/scene/scene.h"
#include "common/tracer/embree.h"

namespace bench::stability {

class PlainEmbree {
  public:
    explicit PlainEmbree(const common::Scene& scene)
        : device_(rtcNewDevice(nullptr), rtcReleaseDevice),
          scene_(rtcNewScene(device_.get()), rtcReleaseScene) {
        const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(common::Vec3), scene.position.size());
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(common::TriangleVertices), scene.triangle.size());
        std::copy(scene.position.begin(), scene.position.end(), static_cast<common::Vec3*>(vertices));
        std::copy(scene.triangle.begin(), scene.triangle.end(),
                  static_cast<common::TriangleVertices*>(indices));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_.get());
    }

    [[nodiscard]] bool meets(const common::Vec3& origin, const common::Vec3& direction) const {
        RTCRayHit ray{};
        ray.ray.org_x = origin.x;
        ray.ray.org_y = origin.y;
        ray.ray.org_z = origin.z;
        ray.ray.dir_x = direction.x;
        ray.ray.dir_y = direction.y;
        ray.ray.dir_z = direction.z;
        ray.ray.tfar = std::numeric_limits<float>::infinity();
        ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        common::intersect_incoherent(scene_.get(), ray);
        return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

  private:
    std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
};

}  // namespace bench::stability
