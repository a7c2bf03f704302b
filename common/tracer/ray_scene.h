// The scene's triangles in Embree: nearest surface along a ray, and whether two points see each other.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "common/core/vec3_array.h"
#include "common/scene/surface_point.h"
#include "common/tracer/photon_surfaces.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace common {

inline constexpr std::uint32_t no_triangle = 0xffffffff;
inline constexpr SurfaceId no_surface{no_triangle, 0, 0};

/// What rays have hit, one entry a ray: SurfaceId's fields, or no_triangle.
struct NearestSurfaces {
    std::vector<std::uint32_t> triangle;
    std::vector<float> u, v;

    [[nodiscard]] SurfaceId operator[](std::size_t i) const { return {triangle[i], u[i], v[i]}; }

    void set(std::size_t i, const SurfaceId& surface) {
        triangle[i] = surface.triangle;
        u[i] = surface.u;
        v[i] = surface.v;
    }

    /// What is new has no defined value.
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

    /// Nearest surface from `origin` along `direction`, if there is one no farther than `direction * reach`.
    /// `direction` may have any length but 0.
    [[nodiscard]] std::optional<SurfaceId> nearest(
        const Vec3& origin, const Vec3& direction,
        float reach = std::numeric_limits<float>::infinity()) const;

    /// The same for many rays, in packets of neighbours: fastest where these travel alike. To the last bit
    /// what they would hit one by one, unless surfaces coincide exactly.
    void nearest(const Vec3Array& origin, const Vec3Array& direction, NearestSurfaces& found) const;

    /// Whether a surface lies between `origin` and `origin + direction * reach`. `direction` may have any
    /// length but 0; `reach` may be infinite.
    [[nodiscard]] bool occluded(const Vec3& origin, const Vec3& direction, float reach) const;

    /// `position`, on a surface with unit normal `normal`, moved off it along `normal` by as much as rounding
    /// may have put it on the wrong side: rays that leave towards that side start here.
    [[nodiscard]] Vec3 off_surface(const Vec3& position, const Vec3& normal) const {
        return position + normal * offset_;
    }
    [[nodiscard]] float surface_offset() const { return offset_; }

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const PhotonSurfaces& surfaces() const { return surfaces_; }

  private:
    struct Release {
        void operator()(RTCDeviceTy* device) const;
        void operator()(RTCSceneTy* scene) const;
    };

    template <int Rays>
    void nearest_in_packets(const Vec3Array& origin, const Vec3Array& direction,
                            NearestSurfaces& found) const;
    void settle_ties(const Vec3Array& origin, const Vec3Array& direction, NearestSurfaces& found) const;

    const Scene* scene_;
    PhotonSurfaces surfaces_;
    float offset_;  ///< world units
    std::unique_ptr<RTCDeviceTy, Release> device_;
    std::unique_ptr<RTCSceneTy, Release> embree_;
};

}  // namespace common
