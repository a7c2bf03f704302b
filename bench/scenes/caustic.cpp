// A scene where light reaches the floor only through glass and by way of mirrors.
#include <numbers>

#include "bench/scenes/scenes.h"
#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

const Box room{{-2, 0, -1.8f}, {2, 2.6f, 2.2f}};
const Vec3 sphere_centre(-0.4f, 0.95f, -0.35f);
constexpr float sphere_radius = 0.42f;

void add_shell(SceneDescription& scene) {
    const auto lamp = ceiling_rectangle(room, {-1.12f, -0.32f}, {-0.88f, -0.08f});
    MeshBuilder pale, blue, ochre, light;
    for (Side side : {Side::bottom, Side::back, Side::front}) add_box_side(pale, room, side, Facing::inward);
    add_ceiling_around(pale, room, lamp);
    add_box_side(blue, room, Side::left, Facing::inward);
    add_box_side(ochre, room, Side::right, Facing::inward);
    light.add_quad(lamp);

    scene.place("walls", pale, scene.add_diffuse("pale", {0.62f, 0.62f, 0.60f}));
    scene.place("left_wall", blue, scene.add_diffuse("blue", {0.20f, 0.32f, 0.55f}));
    scene.place("right_wall", ochre, scene.add_diffuse("ochre", {0.60f, 0.42f, 0.18f}));
    scene.place("lamp", light, scene.add_emitter("lamp", {370.0f, 340.0f, 300.0f}));
}

void add_glass_sphere(SceneDescription& scene) {
    common::Material glass;
    glass.name = "glass";
    glass.kind = common::SurfaceKind::dielectric;
    glass.index_of_refraction = 1.5f;
    MeshBuilder sphere;
    add_sphere(sphere, sphere_centre, sphere_radius, 26);
    scene.place("glass_sphere", sphere, scene.add_material(glass));
}

/// Adds three thin posts that end just below the sphere.
void add_stand(SceneDescription& scene) {
    const float ring_radius = 0.3f, post_radius = 0.012f;
    const float gap = 0.002f;
    const float top = sphere_centre.y - std::sqrt(sphere_radius * sphere_radius - ring_radius * ring_radius) -
                      2 * post_radius;
    MeshBuilder posts;
    for (int post = 0; post < 3; ++post) {
        const float angle = 2 * pi * (static_cast<float>(post) + 0.25f) / 3;
        const Vec3 foot(sphere_centre.x + ring_radius * std::cos(angle), 0,
                        sphere_centre.z + ring_radius * std::sin(angle));
        add_lathe(posts, foot, straight_curve({post_radius, 0}, {post_radius, top - gap}), 12, 8);
        add_lathe(posts, foot, straight_curve({post_radius, top - gap}, {0, top - gap}), 12, 1);
    }
    scene.place("stand", posts, scene.add_diffuse("dark_metal", {0.2f, 0.2f, 0.2f}));
}

/// Adds a standing strip that is bent around `centre`, with a mirror on its concave side.
void add_mirror_band(SceneDescription& scene) {
    const Vec3 centre(0.85f, 0, 0.05f);
    const float radius = 0.62f, thickness = 0.02f, height = 0.5f;
    const float first_angle = -0.46f * pi, sweep = 0.84f * pi;
    const auto at = [=](float r, float y, float s) {
        const float angle = first_angle + sweep * s;
        return centre + Vec3(r * std::cos(angle), y, r * std::sin(angle));
    };
    const float outer = radius + thickness;
    constexpr int segments = 96;
    MeshBuilder mirror, backing;
    mirror.add_surface({segments, 1}, [&](float s, float t) { return at(radius, height * t, s); });
    backing.add_surface({segments, 1}, [&](float s, float t) { return at(outer, height * t, 1 - s); });
    backing.add_surface({segments, 1},
                        [&](float s, float t) { return at(radius + thickness * t, height, s); });
    backing.add_quad({at(radius, 0, 0), at(radius, height, 0), at(outer, height, 0), at(outer, 0, 0)});
    backing.add_quad({at(radius, 0, 1), at(outer, 0, 1), at(outer, height, 1), at(radius, height, 1)});

    common::Material silver;
    silver.name = "mirror";
    silver.kind = common::SurfaceKind::mirror;
    silver.base_color = Rgb(0.95f, 0.95f, 0.95f);
    scene.place("mirror_band", mirror, scene.add_material(silver));
    scene.place("mirror_backing", backing, scene.add_diffuse("backing", {0.45f, 0.40f, 0.36f}));
}

}  // namespace

SceneDescription make_caustic() {
    SceneDescription scene;
    add_shell(scene);
    add_glass_sphere(scene);
    add_stand(scene);
    add_mirror_band(scene);
    scene.add_camera("front", {0, 1.5f, 2.1f}, {0, 0.55f, -0.2f}, 52);
    return scene;
}

}  // namespace scenes
