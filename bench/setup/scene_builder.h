// Builds scenes in code.
#pragma once

#include <Imath/ImathMatrix.h>

#include <numbers>

#include "common/core/sampling.h"
#include "common/scene/surface_point.h"

namespace bench::scene_builder {

using common::Material;
using common::Rgb;
using common::Scene;
using common::SurfaceId;
using common::SurfacePoint;
using common::Vec2;
using common::Vec3;

inline constexpr double pi = std::numbers::pi;

/// Columns may be empty: normals are then those of the triangles, and tangents and texture coordinates are
/// absent.
struct Mesh {
    std::string name;
    std::vector<Vec3> position;
    std::array<std::vector<Vec2>, 2> texcoord;
    std::vector<Vec3> normal;
    std::vector<Vec3> tangent;
    float tangent_sign = 1;
    std::vector<common::TriangleVertices> triangle;
};

/// Makes a parallelogram that faces along cross(edge_u, edge_v). Both sets of texture coordinates are the
/// unit square, with u along edge_u. Its triangles are (0, 0) (1, 0) (1, 1) and (0, 0) (1, 1) (0, 1).
Mesh quad(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v);

/// Returns the surface coordinates of (s, t) in the unit square on a quad whose first triangle is
/// `first_triangle`.
SurfaceId on_quad(std::uint32_t first_triangle, float s, float t);

/// Returns the same mesh with other lightmap coordinates.
Mesh with_lightmap_uv(Mesh mesh, std::vector<Vec2> uv);

/// Returns both meshes as one.
Mesh joined(Mesh a, const Mesh& b);

/// Makes a faceted sphere with smooth vertex normals: an octahedron whose edges are halved `levels` times.
Mesh sphere(const Vec3& center, float radius, int levels);

Material diffuse(const Rgb& albedo, const Rgb& emitted_radiance = Rgb(0, 0, 0));

Material double_sided(Material material);

Material mirror(const Rgb& reflectance = Rgb(1, 1, 1));

Material glass(float index_of_refraction = 1.5f);

/// Adds the mesh as an instance with a material of its own. Returns the instance's index.
std::uint32_t add(Scene& scene, const Mesh& mesh, const Material& material);

/// Returns the six walls of a box, facing inwards: -x, +x, -y, +y, -z, +z.
std::array<Mesh, 6> box_walls(const Vec3& low, const Vec3& high);

/// Makes a closed box with one instance per wall.
Scene closed_box(const Material& material, const Vec3& low = {-1, -1, -1}, const Vec3& high = {1, 1, 1});

/// Returns a rotation about a skew axis, which leaves no edge parallel to a coordinate axis.
Imath::M44f skew_rotation();

/// Rotates everything, lights included, then translates it by `offset`.
Scene moved(Scene scene, const Imath::M44f& rotation, const Vec3& offset);

/// Returns the point as seen from straight in front of the triangle.
SurfacePoint front_of(const Scene& scene, const SurfaceId& surface);

/// Returns the same point with its shading normal `angle` radians off the geometric one.
SurfacePoint tilted(SurfacePoint point, double angle, double turn);

}  // namespace bench::scene_builder
