// A point of a surface: its position and normals.
#pragma once

#include <cstdint>

#include "common/scene/scene.h"

namespace common {

/// A place on the scene's surface: a triangle and barycentric coordinates (Embree's: weight u on the second
/// corner, v on the third).
struct SurfaceId {
    std::uint32_t triangle;
    float u, v;
};

/// A point of an irradiance query.
struct SurfacePoint {
    SurfaceId surface;
    Vec3 position;
    Vec3 geometric_normal;  ///< unit, on the side that is seen
    Vec3 shading_normal;    ///< unit, interpolated and normal-mapped, on the same side
    bool front = true;      ///< whether that side is the triangle's front
};

[[nodiscard]] Vec3 position_at(const Scene& scene, const SurfaceId& surface);
[[nodiscard]] Vec2 texcoord_at(const Scene& scene, const SurfaceId& surface, int texcoord_set);

/// Returns the coordinates at which the texture is read.
[[nodiscard]] Vec2 texcoord_at(const Scene& scene, const SurfaceId& surface, const TextureUse& use);

/// Returns the interpolated vertex normal, unit, on the front side; without normal map.
[[nodiscard]] Vec3 smooth_normal_at(const Scene& scene, const SurfaceId& surface);

/// Where a normal map's u and v point on a surface.
struct MapTangent {
    Vec3 tangent;  ///< world space, along u; not unit; zero where the texture coordinates have no area
    float sign;    ///< glTF's TANGENT.w: the bitangent is sign * cross(normal, tangent)
};

/// The triangle's own, by its derivatives of position by texture coordinate where the map is read: for
/// vertices without tangents.
[[nodiscard]] MapTangent triangle_tangent(const Scene& scene, std::uint32_t triangle, const TextureUse& use);

/// Returns the base colour: factor times texture times vertex colour, in [0, 1].
[[nodiscard]] Rgb base_color_at(const Scene& scene, const SurfaceId& surface);

/// Returns alpha: factor times texture times that of the vertices, in [0, 1], in any alpha mode.
[[nodiscard]] float alpha_at(const Scene& scene, const SurfaceId& surface);

/// Returns the radiance that leaves the surface's emitting face, W/(m^2 sr): factor times texture.
[[nodiscard]] Rgb emitted_radiance_at(const Scene& scene, const SurfaceId& surface);

/// Returns the point seen along `direction` (unit, towards the surface), with normals on the side that is
/// seen.
[[nodiscard]] SurfacePoint surface_point_at(const Scene& scene, const SurfaceId& surface,
                                            const Vec3& direction);

}  // namespace common
