// Tangents, as MikkTSpace makes them, for a primitive whose file gives a normal map but no tangents.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/core/vector.h"
#include "common/gltf/primitive.h"
#include "common/scene/scene.h"

namespace common::gltf {

struct Tangent {
    Vec3 direction{0, 0, 0};  ///< unit, perpendicular to the vertex normal, along increasing u; or zero
    float sign = 1;           ///< as glTF's TANGENT.w

    bool operator==(const Tangent&) const = default;
};

/// The tangents at the corners of a triangle. They belong to the triangle, as triangles at a vertex have
/// different ones where texture coordinates are mirrored.
using CornerTangents = std::array<Tangent, 3>;

/// Returns tangents at the corners of `triangles` for texture coordinates `texcoord` (one per vertex), in the
/// space of `attributes`. Each is a mean over triangles around a vertex, weighted by their angle there (M.
/// Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008). These triangles share position, normal and
/// texture coordinates of the vertex, are connected by edges and are all mirrored or all not. The tangent is
/// zero if none of them has an area in texture space. The result is empty if every triangle's own derivatives
/// already agree with the tangents, as on flat walls: then the derivatives serve as well. Positions and
/// texture coordinates must be finite.
[[nodiscard]] std::vector<CornerTangents> corner_tangents(const Attributes& attributes,
                                                          std::span<const Vec2> texcoord,
                                                          std::span<const TriangleVertices> triangles);

}  // namespace common::gltf
