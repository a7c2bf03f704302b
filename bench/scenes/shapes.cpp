#include "bench/scenes/shapes.h"

#include <numbers>

namespace scenes {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Returns the corners as seen from outside, counter-clockwise from the lower left.
std::array<Vec3, 4> outward_corners(const Vec3& lo, const Vec3& hi, Side side) {
    switch (side) {
        case Side::left:
            return {{{lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, {lo.x, hi.y, lo.z}}};
        case Side::right:
            return {{{hi.x, lo.y, hi.z}, {hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z}}};
        case Side::bottom:
            return {{{lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {lo.x, lo.y, hi.z}}};
        case Side::top:
            return {{{lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z}}};
        case Side::back:
            return {{{hi.x, lo.y, lo.z}, {lo.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z}}};
        case Side::front:
            break;
    }
    return {{{lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}}};
}

Cells cells_of(const Box& box, Side side) {
    switch (side) {
        case Side::left:
        case Side::right:
            return {box.cells[2], box.cells[1]};
        case Side::bottom:
        case Side::top:
            return {box.cells[0], box.cells[2]};
        case Side::back:
        case Side::front:
            break;
    }
    return {box.cells[0], box.cells[1]};
}

/// Exactly odd in 2i - n, so that the patches of a sphere meet exactly.
float equal_angle_step(int i, int n) {
    return std::tan(pi / 4 * static_cast<float>(2 * i - n) / static_cast<float>(n));
}

float catmull_rom(float a, float b, float c, float d, float x) {
    return b + 0.5f * x * (c - a + x * (2 * a - 5 * b + 4 * c - d + x * (3 * (b - c) + d - a)));
}

}  // namespace

void add_box_side(MeshBuilder& builder, const Box& box, Side side, Facing facing, const CellFilter& present) {
    std::array<Vec3, 4> corner = outward_corners(box.min, box.max, side);
    if (facing == Facing::inward) corner = {corner[1], corner[0], corner[3], corner[2]};
    builder.add_quad(corner, cells_of(box, side), present);
}

void add_box(MeshBuilder& builder, const Box& box, std::initializer_list<Side> hidden) {
    for (Side side : {Side::left, Side::right, Side::bottom, Side::top, Side::back, Side::front})
        if (std::find(hidden.begin(), hidden.end(), side) == hidden.end())
            add_box_side(builder, box, side, Facing::outward);
}

void add_frame(MeshBuilder& builder, const std::array<Vec3, 4>& outer, const std::array<Vec3, 4>& inner) {
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        builder.add_quad({outer[i], outer[next], inner[next], inner[i]});
    }
}

std::array<Vec3, 4> ceiling_rectangle(const Box& room, Vec2 min, Vec2 max) {
    const float y = room.max.y;
    return {{{min.x, y, min.y}, {max.x, y, min.y}, {max.x, y, max.y}, {min.x, y, max.y}}};
}

void add_ceiling_around(MeshBuilder& builder, const Box& room, const std::array<Vec3, 4>& opening) {
    const Vec2 min(room.min.x, room.min.z), max(room.max.x, room.max.z);
    add_frame(builder, ceiling_rectangle(room, min, max), opening);
}

void add_lathe(MeshBuilder& builder, const Vec3& centre, const Curve& profile, int segments, int rings) {
    builder.add_surface({segments, rings}, [&](float s, float t) {
        const Vec2 p = profile(t);
        return centre + Vec3(p.x * std::cos(-2 * pi * s), p.y, p.x * std::sin(-2 * pi * s));
    });
}

void add_sphere(MeshBuilder& builder, const Vec3& centre, float radius, int cells_per_edge) {
    const int n = cells_per_edge;
    const float edge = equal_angle_step(n, n);
    for (int axis = 0; axis < 3; ++axis) {
        for (float sign : {-1.0f, 1.0f}) {
            builder.add_surface({n, n}, [&](float s, float t) {
                // Steps on the grid are exact; only normals use values between them.
                const auto at = [&](float x) {
                    const float cell = x * static_cast<float>(n);
                    const float nearest = std::round(cell);
                    const float step = equal_angle_step(static_cast<int>(nearest), n);
                    if (std::abs(cell - nearest) < 1e-4f) return step;
                    return std::tan(pi / 4 * (2 * x - 1));
                };
                Vec3 cube;
                cube[axis] = sign * edge;
                cube[(axis + 1) % 3] = sign * at(s);
                cube[(axis + 2) % 3] = at(t);
                return centre + cube * (radius / cube.length());
            });
        }
    }
}

Curve smooth_curve(std::span<const Vec2> points) {
    return [points = std::vector<Vec2>(points.begin(), points.end())](float t) {
        const int last = static_cast<int>(points.size()) - 1;
        const float along = t * static_cast<float>(last);
        const int i = std::clamp(static_cast<int>(std::floor(along)), 0, last - 1);
        const Vec2 b = points[i], c = points[i + 1];
        const Vec2 a = i > 0 ? points[i - 1] : b * 2.0f - c;
        const Vec2 d = i + 1 < last ? points[i + 2] : c * 2.0f - b;
        const float x = along - static_cast<float>(i);
        if (x == 1) return c;  // so that profiles end on the axis exactly
        return Vec2(catmull_rom(a.x, b.x, c.x, d.x, x), catmull_rom(a.y, b.y, c.y, d.y, x));
    };
}

Curve straight_curve(Vec2 a, Vec2 b) {
    return [a, b](float t) { return a * (1 - t) + b * t; };
}

}  // namespace scenes
