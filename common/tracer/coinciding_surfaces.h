// Which of several triangles at one place a ray meets.
#pragma once

#include <vector>

#include "common/scene/surface_point.h"
#include "common/tracer/embree_scene.h"

namespace common {

/// Of triangles that coincide, Embree finds the one or the other, by the packet that a ray is in and by how
/// it was built. All light and every camera must meet the same one. It is the first of these that differs:
/// 1. a surface that lets no light through there, or what passes it would be behind it;
/// 2. one that is for the side that the ray comes from: its front, or either where it is double-sided or
///    glass;
/// 3. one that emits to that side;
/// 4. one that has no holes anywhere;
/// 5. the first in the file.
class CoincidingSurfaces {
  public:
    /// `triangles` as CoincidingTriangles has them, found with this `tolerance` (world units). `device` and
    /// `scene` must outlive this object.
    CoincidingSurfaces(RTCDeviceTy* device, const Scene& scene, std::span<const std::uint32_t> triangles,
                       float tolerance);

    /// Whether `triangle` may coincide with another.
    [[nodiscard]] bool contains(std::uint32_t triangle) const { return contains_[triangle] != 0; }

    /// What a ray (`direction` unit) meets that has found a surface, of those contained, at this distance.
    [[nodiscard]] SurfaceId met_at(const SurfaceId& found, const Vec3& origin, const Vec3& direction,
                                   float distance) const;

  private:
    struct Query;
    static void show(const RTCFilterFunctionNArguments* arguments);

    const Scene* scene_;
    float tolerance_;
    std::vector<std::uint8_t> contains_;    ///< per triangle of the scene
    std::vector<std::uint32_t> triangles_;  ///< by Embree's number
    EmbreeScene embree_;                    ///< of them alone: all that lie on a ray are found
};

}  // namespace common
