// Common solids and surfaces, as patches of a mesh.
#pragma once

#include <initializer_list>
#include <span>

#include "bench/scenes/mesh_builder.h"

namespace scenes {

enum class Side { left, right, bottom, top, back, front };  ///< -x, +x, -y, +y, -z, +z

enum class Facing { outward, inward };  ///< inward for the walls of a room

struct Box {
    Vec3 min, max;
    std::array<int, 3> cells{1, 1, 1};  ///< along x, y and z
};

inline const Vec3 origin(0, 0, 0);

/// The profile of a solid of revolution: maps t from 0 to 1 to (radius, height) in metres.
using Curve = std::function<Vec2(float t)>;

/// Adds one face of a box. Textures are upright on the four walls. Cells count from the lower left corner as
/// seen from the front.
void add_box_side(MeshBuilder& builder, const Box& box, Side side, Facing facing,
                  const CellFilter& present = {});

/// Adds all outward faces except `hidden` ones, which touch what the box stands on.
void add_box(MeshBuilder& builder, const Box& box, std::initializer_list<Side> hidden = {});

/// Adds the flat rim between two coplanar rectangles, mitred at the corners: four quads that share all their
/// edges. Corners are counter-clockwise from the front, and both rectangles start at the same corner.
void add_frame(MeshBuilder& builder, const std::array<Vec3, 4>& outer, const std::array<Vec3, 4>& inner);

/// Returns a horizontal rectangle at the top of a room, facing down; corners are (x, z).
[[nodiscard]] std::array<Vec3, 4> ceiling_rectangle(const Box& room, Vec2 min, Vec2 max);

/// Adds the ceiling of a room without the rectangle `opening`, which a flush lamp fills.
void add_ceiling_around(MeshBuilder& builder, const Box& room, const std::array<Vec3, 4>& opening);

/// Rotates the profile about a vertical axis through `centre`. The front is on the right of the curve's
/// direction, so a profile that rises faces outward.
void add_lathe(MeshBuilder& builder, const Vec3& centre, const Curve& profile, int segments, int rings);

/// Adds a sphere of six patches, which have neither poles nor slivers.
void add_sphere(MeshBuilder& builder, const Vec3& centre, float radius, int cells_per_edge);

/// Returns a smooth curve through the points (Catmull-Rom, uniform).
[[nodiscard]] Curve smooth_curve(std::span<const Vec2> points);

/// Returns the straight line from `a` to `b`.
[[nodiscard]] Curve straight_curve(Vec2 a, Vec2 b);

}  // namespace scenes
