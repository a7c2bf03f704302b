// The scene's triangles in Embree: nearest surface along a ray, and whether two points see each other.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "common/core/vec3_array.h"
#include "common/scene/coinciding_triangles.h"
#include "common/scene/surface_point.h"
#include "common/tracer/coinciding_surfaces.h"
#include "common/tracer/embree_scene.h"
#include "common/tracer/photon_surfaces.h"

namespace common {

inline constexpr std::uint32_t no_triangle = 0xffffffff;
inline constexpr SurfaceId no_surface{no_triangle, 0, 0};

/// The hits of rays, one entry per ray: SurfaceId's fields, or no_triangle.
struct NearestSurfaces {
    std::vector<std::uint32_t> triangle;
    std::vector<float> u, v;

    [[nodiscard]] SurfaceId operator[](std::size_t i) const { return {triangle[i], u[i], v[i]}; }

    void set(std::size_t i, const SurfaceId& surface) {
        triangle[i] = surface.triangle;
        u[i] = surface.u;
        v[i] = surface.v;
    }

    /// The values of new elements are undefined.
    void resize(std::size_t rays) {
        triangle.resize(rays);
        u.resize(rays);
        v.resize(rays);
    }
};

class RayScene {
  public:
    /// Builds Embree's acceleration structure. `scene` must outlive this object.
    explicit RayScene(const Scene& scene);

    /// Returns the nearest surface from `origin` along `direction`, if there is one no farther than
    /// `direction * reach`. `direction` may have any length but 0. If several coincide, CoincidingSurfaces
    /// decides.
    [[nodiscard]] std::optional<SurfaceId> nearest(
        const Vec3& origin, const Vec3& direction,
        float reach = std::numeric_limits<float>::infinity()) const;

    /// Finds the same for many rays, in packets of neighbours; fastest if these travel alike. The result
    /// equals that of single rays to the last bit.
    void nearest(const Vec3Array& origin, const Vec3Array& direction, NearestSurfaces& found) const;

    /// Returns whether a surface lies between `origin` and `origin + direction * reach`. `direction` may have
    /// any length but 0; `reach` may be infinite.
    [[nodiscard]] bool occluded(const Vec3& origin, const Vec3& direction, float reach) const;

    /// Returns whether rays that reach `position`, on `triangle`, from the side of `normal` (unit) hit
    /// another triangle that coincides with it. Then its emission to that side is not visible, and must not
    /// emit photons.
    [[nodiscard]] bool is_covered(std::uint32_t triangle, const Vec3& position, const Vec3& normal) const;

    /// Returns whether that may happen to a triangle that emits.
    [[nodiscard]] bool may_cover_lights() const { return may_cover_lights_; }

    /// Returns `position`, on a surface with unit normal `normal`, offset along `normal` by the largest
    /// rounding error. Rays that leave to that side start here.
    [[nodiscard]] Vec3 off_surface(const Vec3& position, const Vec3& normal) const {
        return position + normal * offset_;
    }
    [[nodiscard]] float surface_offset() const { return offset_; }

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const PhotonSurfaces& surfaces() const { return surfaces_; }

    /// Returns the triangles that lie within half of `surface_offset` of each other.
    [[nodiscard]] const CoincidingTriangles& coinciding_triangles() const { return coinciding_triangles_; }

  private:
    [[nodiscard]] bool coincides(std::uint32_t triangle) const {
        return coinciding_ && coinciding_->contains(triangle);
    }

    template <int Rays>
    void nearest_in_packets(const Vec3Array& origin, const Vec3Array& direction,
                            NearestSurfaces& found) const;
    void settle_ties(const Vec3Array& origin, const Vec3Array& direction, NearestSurfaces& found) const;

    const Scene* scene_;
    PhotonSurfaces surfaces_;
    float offset_;  ///< world units
    EmbreeDevice device_;
    EmbreeScene embree_;
    CoincidingTriangles coinciding_triangles_;
    std::unique_ptr<const CoincidingSurfaces> coinciding_;  ///< null if none coincide
    bool may_cover_lights_ = false;
};

}  // namespace common
