// A primitive's attributes moved from the space of their node to world space.
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

/// Moves positions, normals and tangents to world space and makes normals and tangents unit, or zero where
/// they have no direction. Under a mirroring transform it turns the triangles round, so that they stay
/// counter-clockwise seen from the front. Throws InputError for positions that are not finite in world space.
void to_world_space(Attributes& attributes, std::span<TriangleVertices> triangles,
                    const Imath::M44d& to_world);

/// The same for tangents that were made for the corners of the triangles.
void to_world_space(std::span<CornerTangents> tangents, const Imath::M44d& to_world);

/// The same with a transform for each vertex, as skins have; the first corner's decides whether a triangle is
/// turned round.
void to_world_space(Attributes& attributes, std::span<TriangleVertices> triangles,
                    std::span<const Imath::M44d> to_world);

/// Unit normal of a triangle, out of the side from which it is counter-clockwise; zero where it has no area.
[[nodiscard]] Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace common::gltf
