// Transforms a primitive's attributes from the space of their node to world space.
#pragma once

#include <Imath/ImathMatrix.h>

#include <span>
#include <string>

#include "common/gltf/primitive.h"
#include "common/gltf/tangents.h"
#include "common/gltf/warnings.h"

namespace common::gltf {

/// Sets normals, tangents and texture coordinates that are not finite to zero, with a warning about the mesh
/// `name`.
void repair(Attributes& attributes, const std::string& name, Warnings& warnings);

/// Transforms positions, normals and tangents to world space and normalises normals and tangents, to zero if
/// they have no direction. A mirroring transform reverses the triangles' winding, so that they stay
/// counter-clockwise seen from the front. Throws InputError for positions that are not finite in world space.
void to_world_space(Attributes& attributes, std::span<TriangleVertices> triangles,
                    const Imath::M44d& to_world);

/// Does the same for tangents that were made for the corners of the triangles.
void to_world_space(std::span<CornerTangents> tangents, const Imath::M44d& to_world);

/// Does the same with a transform for each vertex, as skins have. The transform of its first corner decides
/// whether a triangle's winding is reversed.
void to_world_space(Attributes& attributes, std::span<TriangleVertices> triangles,
                    std::span<const Imath::M44d> to_world);

/// Returns the unit normal of a triangle, on the side from which it is counter-clockwise; zero if it has no
/// area.
[[nodiscard]] Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace common::gltf
