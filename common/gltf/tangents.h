// Tangents for a primitive with a normal map whose file gives none, as MikkTSpace makes them.
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

/// One for each corner of a triangle: where texture coordinates are mirrored at a vertex, its triangles have
/// different ones.
using CornerTangents = std::array<Tangent, 3>;

/// Tangents at the corners of `triangles` for texture coordinates `texcoord` (one per vertex), in the space
/// of `attributes`: means over the triangles around a vertex that share its position, normal and texture
/// coordinates, hang together by edges and are mirrored alike, each weighted by its angle there (M.
/// Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008). Zero where no such triangle has an area in
/// texture space. None at all where every triangle's own derivatives already agree with them, as on flat
/// walls: those serve as well. Positions and texture coordinates must be finite.
[[nodiscard]] std::vector<CornerTangents> corner_tangents(const Attributes& attributes,
                                                          std::span<const Vec2> texcoord,
                                                          std::span<const TriangleVertices> triangles);

}  // namespace common::gltf
