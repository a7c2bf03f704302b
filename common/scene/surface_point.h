// What is known about one point of a surface: where it is and which way it faces.
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

/// A point at which irradiance is asked for.
struct SurfacePoint {
    SurfaceId surface;
    Vec3 position;
    Vec3 geometric_normal;  ///< unit, on the side that is looked at
    Vec3 shading_normal;    ///< unit, interpolated and normal-mapped, on the same side
    bool front = true;      ///< whether that side is the triangle's front
};

[[nodiscard]] Vec3 position_at(const Scene& scene, const SurfaceId& surface);
[[nodiscard]] Vec2 texcoord_at(const Scene& scene, const SurfaceId& surface, int texcoord_set);

/// Where a texture is read.
[[nodiscard]] Vec2 texcoord_at(const Scene& scene, const SurfaceId& surface, const TextureUse& use);

/// Interpolated vertex normal, unit, on the front side; no normal map.
[[nodiscard]] Vec3 smooth_normal_at(const Scene& scene, const SurfaceId& surface);

/// Where a normal map's u and v point on a surface.
struct MapTangent {
    Vec3 tangent;  ///< world space, along u; not unit; zero where the texture coordinates have no area
    float sign;    ///< glTF's TANGENT.w: the bitangent is sign * cross(normal, tangent)
};

/// The triangle's own, by its derivatives of position by texture coordinate where the map is read: for
/// vertices without tangents.
[[nodiscard]] MapTangent triangle_tangent(const Scene& scene, std::uint32_t triangle, const TextureUse& use);

/// Base colour: factor times texture times vertex colour, in [0, 1].
[[nodiscard]] Rgb base_color_at(const Scene& scene, const SurfaceId& surface);

/// Alpha: factor times texture times that of the vertices, in [0, 1], whatever the material makes of it.
[[nodiscard]] float alpha_at(const Scene& scene, const SurfaceId& surface);

/// W/(m^2 sr) leaving the surface's emitting face: factor times texture.
[[nodiscard]] Rgb emitted_radiance_at(const Scene& scene, const SurfaceId& surface);

/// The point seen along `direction` (unit, towards the surface), with its normals on the side that is seen.
[[nodiscard]] SurfacePoint surface_point_at(const Scene& scene, const SurfaceId& surface,
                                            const Vec3& direction);

}  // namespace common
