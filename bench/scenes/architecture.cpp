#include "bench/scenes/architecture.h"

#include <numbers>

#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float stone_texture = 1.5f;  ///< metres
constexpr float block_height = 0.12f;  ///< of plinth and abacus

Box square_block(float side, float bottom, float top) {
    return {{-side / 2, bottom, -side / 2}, {side / 2, top, side / 2}};
}

/// A half-round bulge from `bottom` to `top` on a core of radius `core`.
Curve torus_curve(float core, float bulge, float bottom, float top) {
    return [=](float t) {
        return Vec2(core + bulge * std::sin(pi * t), bottom + (top - bottom) * 0.5f * (1 - std::cos(pi * t)));
    };
}

void add_plinth_and_abacus(MeshBuilder& builder, float height) {
    add_box(builder, square_block(arcade::abacus, 0, block_height), {Side::bottom});
    add_box(builder, square_block(arcade::abacus, height - block_height, height));
}

/// Adds a flat ring that closes a moulding towards the flutes of the shaft. It faces up if it leads inward.
void add_ledge(MeshBuilder& builder, float from_radius, float to_radius, float height, int segments) {
    add_lathe(builder, origin, straight_curve({from_radius, height}, {to_radius, height}), segments, 1);
}

Surface fluted_shaft(float radius, float bottom, float top, int flutes) {
    return [=](float s, float t) {
        const float angle = -2 * pi * s;
        const float entasis = 1 - 0.14f * t * t;
        const float flute = std::abs(std::cos(0.5f * static_cast<float>(flutes) * angle));
        const float r = radius * entasis * (1 - 0.07f * flute);
        return Vec3(r * std::cos(angle), bottom + (top - bottom) * t, r * std::sin(angle));
    };
}

/// Arch in the plane of the wall: 0 at the left springing, 1 at the right one.
Vec2 on_arch(float radius, float s) {
    const float angle = pi * (1 - s);
    const float x = radius * std::cos(angle), y = radius * std::sin(angle);
    return s <= 0 ? Vec2(-radius, 0) : s >= 1 ? Vec2(radius, 0) : Vec2(x, y);
}

constexpr int arch_segments = 24;
constexpr float archivolt_width = 0.2f;
constexpr float archivolt_depth = 0.06f;

/// One face of the wall above the archivolt: vertical rulings from the arch to the top edge.
void add_wall_above_arch(MeshBuilder& builder) {
    const float z = arcade::wall_thickness / 2, top = arcade::wall_height, end = arcade::bay / 2;
    const float radius = arcade::arch_radius + archivolt_width;
    builder.add_surface({arch_segments, 3}, [=](float s, float t) {
        const Vec2 foot = on_arch(radius, s);
        return Vec3(foot.x, foot.y + (top - foot.y) * t, z);
    });
    builder.add_quad({{{-end, 0, z}, {-radius, 0, z}, {-radius, top, z}, {-end, top, z}}}, {1, 3});
    builder.add_quad({{{radius, 0, z}, {end, 0, z}, {end, top, z}, {radius, top, z}}}, {1, 3});
}

/// Moulded band round the arch, from the edge of the soffit to the wall.
void add_archivolt(MeshBuilder& builder) {
    const float z = arcade::wall_thickness / 2;
    const std::array<Vec2, 6> profile{{{0, archivolt_depth},
                                       {0.05f, archivolt_depth},
                                       {0.08f, 0.6f * archivolt_depth},
                                       {0.12f, 0.6f * archivolt_depth},
                                       {0.16f, archivolt_depth},
                                       {archivolt_width, 0}}};
    const Curve moulding = smooth_curve(profile);
    builder.add_surface({arch_segments, 8}, [=](float s, float t) {
        const Vec2 across = moulding(t);
        const Vec2 p = on_arch(arcade::arch_radius + across.x, s);
        return Vec3(p.x, p.y, z + across.y);
    });
}

/// Underside of the arch over half the wall's thickness.
void add_soffit(MeshBuilder& builder) {
    const float depth = arcade::wall_thickness / 2 + archivolt_depth;
    builder.add_surface({arch_segments, 2}, [=](float s, float t) {
        const Vec2 p = on_arch(arcade::arch_radius, s);
        return Vec3(p.x, p.y, depth * t);
    });
}

}  // namespace

Mesh make_fluted_column(float height) {
    constexpr int segments = 36, flutes = 16;
    const float shaft_bottom = 0.30f, shaft_top = height - 0.42f, radius = 0.27f, neck = 0.86f * radius;
    MeshBuilder builder(stone_texture);
    add_plinth_and_abacus(builder, height);
    add_lathe(builder, origin, torus_curve(radius, 0.07f, block_height, 0.22f), segments, 10);
    add_lathe(builder, origin, torus_curve(radius, 0.035f, 0.22f, shaft_bottom), segments, 8);
    builder.add_surface({flutes * 4, 8}, fluted_shaft(radius, shaft_bottom, shaft_top, flutes));
    add_ledge(builder, radius, 0.9f * radius, shaft_bottom, segments);
    add_ledge(builder, 0.9f * neck, neck, shaft_top, segments);
    add_lathe(builder, origin, torus_curve(neck, 0.03f, shaft_top, shaft_top + 0.07f), segments, 8);
    const std::array<Vec2, 5> echinus{{{neck, shaft_top + 0.07f},
                                       {neck + 0.01f, shaft_top + 0.13f},
                                       {neck + 0.05f, shaft_top + 0.20f},
                                       {neck + 0.10f, shaft_top + 0.26f},
                                       {neck + 0.105f, height - block_height}}};
    add_lathe(builder, origin, smooth_curve(echinus), segments, 12);
    return builder.finish();
}

Mesh make_slender_column(float height) {
    constexpr int segments = 32;
    const float shaft_bottom = 0.24f, shaft_top = height - 0.36f, radius = 0.19f, neck = 0.165f;
    MeshBuilder builder(stone_texture);
    add_plinth_and_abacus(builder, height);
    add_lathe(builder, origin, torus_curve(0.19f, 0.07f, block_height, shaft_bottom), segments, 10);
    const std::array<Vec2, 4> shaft{{{radius, shaft_bottom},
                                     {radius, shaft_bottom + 0.6f},
                                     {0.97f * radius, shaft_bottom + 1.2f},
                                     {neck, shaft_top}}};
    add_lathe(builder, origin, smooth_curve(shaft), segments, 8);
    add_lathe(builder, origin, torus_curve(neck, 0.03f, shaft_top, shaft_top + 0.06f), segments, 8);
    const std::array<Vec2, 4> bell{{{neck, shaft_top + 0.06f},
                                    {neck + 0.02f, shaft_top + 0.12f},
                                    {neck + 0.07f, shaft_top + 0.19f},
                                    {neck + 0.16f, height - block_height}}};
    add_lathe(builder, origin, smooth_curve(bell), segments, 10);
    return builder.finish();
}

Mesh make_arch_bay() {
    MeshBuilder half(stone_texture);
    add_wall_above_arch(half);
    add_archivolt(half);
    add_soffit(half);
    half.repeat_turned_half_round();
    return half.finish();
}

Mesh make_corner_pier(float springing_height) {
    const float side = arcade::abacus, h = springing_height, top = h + arcade::wall_height;
    const float cap = 0.14f;
    MeshBuilder builder(stone_texture);
    add_box(builder, {{0, 0, 0}, {side, top, side}, {1, 4, 1}}, {Side::bottom, Side::top});
    const float reach = arcade::abacus / 2, in = 0.08f;
    // Pillar shafts are narrower than the cap that carries the arch.
    add_box(builder, {{-reach + in, 0, in}, {0, h - cap, side - in}, {1, 2, 1}},
            {Side::bottom, Side::right, Side::top});
    add_box(builder, {{-reach, h - cap, 0}, {0, h, side}}, {Side::right});
    add_box(builder, {{in, 0, -reach + in}, {side - in, h - cap, 0}, {1, 2, 1}},
            {Side::bottom, Side::front, Side::top});
    add_box(builder, {{0, h - cap, -reach}, {side, h, 0}}, {Side::front});
    return builder.finish();
}

Mesh make_balustrade_bay() {
    const float clear_half = (arcade::bay - arcade::abacus) / 2;
    // The open ends of plinth and rail lie inside the columns' plinths and shafts.
    const float plinth_half = clear_half + 0.1f, rail_half = clear_half + 0.24f;
    const float plinth = block_height - 0.02f, rail_bottom = arcade::rail_height - 0.12f;
    constexpr int balusters = 9;
    const float h = rail_bottom - plinth;
    const std::array<Vec2, 10> profile{{{0.060f, plinth},
                                        {0.062f, plinth + 0.06f * h},
                                        {0.034f, plinth + 0.13f * h},
                                        {0.055f, plinth + 0.26f * h},
                                        {0.072f, plinth + 0.38f * h},
                                        {0.058f, plinth + 0.54f * h},
                                        {0.032f, plinth + 0.72f * h},
                                        {0.030f, plinth + 0.84f * h},
                                        {0.056f, plinth + 0.92f * h},
                                        {0.060f, rail_bottom}}};
    MeshBuilder builder(stone_texture);
    add_box(builder, {{-plinth_half, 0, -0.13f}, {plinth_half, plinth, 0.13f}, {8, 1, 1}},
            {Side::bottom, Side::left, Side::right});
    add_box(builder, {{-rail_half, rail_bottom, -0.14f}, {rail_half, arcade::rail_height, 0.14f}, {8, 1, 1}},
            {Side::left, Side::right});
    for (int i = 0; i < balusters; ++i) {
        const float x = clear_half * (2 * (static_cast<float>(i) + 0.5f) / balusters - 1);
        add_lathe(builder, {x, 0, 0}, smooth_curve(profile), 10, 16);
    }
    return builder.finish();
}

Mesh make_cornice(float half_x, float half_z, float bottom, float top) {
    const float h = top - bottom;
    const std::array<Vec2, 7> profile{{{0, bottom},
                                       {0.04f, bottom + 0.02f * h},
                                       {0.05f, bottom + 0.30f * h},
                                       {0.11f, bottom + 0.60f * h},
                                       {0.15f, bottom + 0.75f * h},
                                       {0.14f, bottom + 0.97f * h},
                                       {0, top}}};
    const Curve moulding = smooth_curve(profile);
    MeshBuilder builder(stone_texture);
    for (int side = 0; side < 4; ++side) {
        const bool along_x = side % 2 == 0;
        const float sign = side < 2 ? 1.0f : -1.0f;
        const float reach = along_x ? half_x : half_z, distance = along_x ? half_z : half_x;
        builder.add_surface({along_x ? 12 : 4, 12}, [=](float s, float t) {
            const Vec2 p = moulding(t);
            const float along = (reach - p.x) * (2 * s - 1), across = distance - p.x;
            return along_x ? Vec3(-sign * along, p.y, sign * across) : Vec3(sign * across, p.y, sign * along);
        });
    }
    return builder.finish();
}

}  // namespace scenes
