// Scenes with vertex colours, holes and thin sheets.
#pragma once

#include "tests/support/scene_builder.h"

namespace tests {

inline Material thin_sheet(float index_of_refraction = 1.5f, const Rgb& tint = Rgb(1, 1, 1)) {
    Material material = glass(index_of_refraction);
    material.kind = common::SurfaceKind::thin_sheet;
    material.base_color = tint;
    return material;
}

/// Returns the material with partial coverage `alpha`.
inline Material blended(Material material, float alpha) {
    material.alpha_mode = common::AlphaMode::blend;
    material.alpha = alpha;
    return material;
}

/// Returns the material, which exists where alpha is at least half.
inline Material masked(Material material, float alpha = 1) {
    material.alpha_mode = common::AlphaMode::mask;
    material.alpha = alpha;
    return material;
}

/// Returns the material with a base colour from a new texture of the scene. It is white, with an alpha of 1
/// in every other one of 8 x 8 squares, and of 0 in the rest. It is filtered, so that half of it is above
/// 1/2.
inline Material checkered(Scene& scene, Material material) {
    constexpr int size = 64, square = 8;
    std::vector<std::uint8_t> alpha(size * size);
    for (int i = 0; i < size * size; ++i)
        alpha[static_cast<std::size_t>(i)] = (i % size / square + i / size / square) % 2 == 0 ? 255 : 0;
    material.base_color_texture.texture = static_cast<std::int32_t>(scene.texture.size());
    scene.texture.emplace_back("checkered", size, size, std::vector<std::uint8_t>(3 * size * size, 255),
                               common::ColorSpace::linear, common::Wrap::repeat, common::Wrap::repeat, alpha);
    return material;
}

/// Sets the colours of an instance's vertices to `of(position)`. All other vertices of the scene that have no
/// colour yet become white.
template <class Color>
void set_color(Scene& scene, std::uint32_t instance, Color of) {
    scene.color.resize(scene.position.size(), Rgb(1, 1, 1));
    scene.alpha.resize(scene.position.size(), 1.0f);
    const common::MeshInstance& range = scene.instance[instance];
    for (std::uint32_t t = range.first_triangle; t < range.first_triangle + range.triangle_count; ++t)
        for (const std::uint32_t vertex : scene.triangle[t]) scene.color[vertex] = of(scene.position[vertex]);
}

/// A closed, rotated room with everything that light may pass through and all kinds of vertex colours. It has
/// a wall with a gradient, a fence with holes, a partly transparent sheet whose alpha varies, a tinted pane,
/// and two instances of one ball, one coloured and one blended. The lamp has holes too. Instances are in the
/// order of `RoomPart`.
enum RoomPart : std::uint32_t {
    first_wall,
    lamp = 6,
    fence,
    veil,
    pane,
    colored_ball,
    blended_ball,
    room_parts
};

inline Scene see_through_room() {
    Scene scene = closed_box(diffuse(Rgb(0.6f, 0.5f, 0.4f)));
    const Material grey = diffuse(Rgb(0.5f, 0.5f, 0.5f)), dark = diffuse(Rgb(0.2f, 0.2f, 0.2f), Rgb(6, 5, 4));
    add(scene, quad({-0.5f, 0.95f, -0.5f}, {1, 0, 0}, {0, 0, 1}), masked(checkered(scene, dark)));  // down
    add(scene, quad({-0.3f, -0.9f, -0.9f}, {0, 1.6f, 0}, {0, 0, 1.8f}),
        double_sided(masked(checkered(scene, diffuse(Rgb(0.7f, 0.6f, 0.2f))))));
    add(scene, quad({-0.9f, -0.6f, -0.9f}, {0, 0, 1.8f}, {1.8f, 0.1f, 0}),
        double_sided(blended(diffuse(Rgb(0.3f, 0.8f, 0.6f)), 0.8f)));
    add(scene, quad({-0.9f, 0.3f, -0.9f}, {0, 0, 1.8f}, {1.8f, 0, 0}),
        thin_sheet(1.6f, Rgb(0.9f, 0.8f, 0.9f)));
    const Mesh ball = sphere({0, 0, 0}, 0.25f, 2);
    for (const bool first : {true, false}) {
        Mesh instance = ball;
        for (Vec3& p : instance.position) p += first ? Vec3(0.4f, 0, -0.4f) : Vec3(0.4f, 0, 0.4f);
        add(scene, instance, first ? grey : blended(grey, 0.6f));
    }
    set_color(scene, first_wall, [](const Vec3& p) { return Rgb(1, 0.5f * (1 + p.y), 0.5f); });
    set_color(scene, colored_ball, [](const Vec3& p) { return Rgb(1 - p.y, 1, 0.2f + p.x) * 0.8f; });
    const common::MeshInstance& sheet = scene.instance[veil];
    for (std::uint32_t t = sheet.first_triangle; t < sheet.first_triangle + sheet.triangle_count; ++t)
        for (const std::uint32_t vertex : scene.triangle[t])
            scene.alpha[vertex] = 0.5f + 0.4f * scene.position[vertex].x;
    return moved(scene, skew_rotation(), {0.5f, -1, 2});
}

}  // namespace tests
