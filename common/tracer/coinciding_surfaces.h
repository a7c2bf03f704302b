// Decides which of several triangles at one place a ray hits.
#pragma once

#include <vector>

#include "common/scene/surface_point.h"
#include "common/tracer/embree_scene.h"

namespace common {

/// Of triangles that coincide, Embree finds one or the other, depending on the packet that a ray is in and on
/// how Embree was built. All light and every camera must hit the same one. The first of these criteria that
/// differs decides:
/// 1. a surface that transmits no light there, as light through the other one would continue behind it;
/// 2. one for the side that the ray comes from: its front, or either if it is double-sided or glass;
/// 3. one that emits to that side;
/// 4. one that has no holes anywhere;
/// 5. the first in the file.
class CoincidingSurfaces {
  public:
    /// `triangles` is that of CoincidingTriangles, found with this `tolerance` (world units). `device` and
    /// `scene` must outlive this object.
    CoincidingSurfaces(RTCDeviceTy* device, const Scene& scene, std::span<const std::uint32_t> triangles,
                       float tolerance);

    /// Returns whether `triangle` may coincide with another.
    [[nodiscard]] bool contains(std::uint32_t triangle) const { return contains_[triangle] != 0; }

    /// Returns what a ray (`direction` unit) hits if it has found one of the contained surfaces at this
    /// distance.
    [[nodiscard]] SurfaceId met_at(const SurfaceId& found, const Vec3& origin, const Vec3& direction,
                                   float distance) const;

  private:
    struct Query;
    static void show(const RTCFilterFunctionNArguments* arguments);

    const Scene* scene_;
    float tolerance_;
    std::vector<std::uint8_t> contains_;    ///< per triangle of the scene
    std::vector<std::uint32_t> triangles_;  ///< by Embree's number
    EmbreeScene embree_;                    ///< of these alone; its filter visits all that lie on a ray
};

}  // namespace common
