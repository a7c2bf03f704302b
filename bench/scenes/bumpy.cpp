// Two bays with the same normal-mapped walls: one under a hard spot, the other under a soft ceiling panel.
#include <numbers>

#include "bench/scenes/scenes.h"
#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

constexpr int texture_pixels = 512;
constexpr float texture_size = 1.5f;  // metres
constexpr float slope_60_degrees = std::numbers::pi_v<float> / 3;
constexpr float slope_55_degrees = 0.96f;

const Box room{{-3, 0, -2.25f}, {3, 3, 2.25f}};
const Box partition{{-0.1f, 0, -2.25f}, {0.1f, 3, 0.4f}, {1, 15, 1}};

struct Materials {
    int bricks, domes, ridges, plain;
};

Materials add_materials(SceneDescription& scene) {
    const SurfacePattern bricks = masonry({.columns = 2,
                                           .courses = 6,
                                           .running_bond = true,
                                           .joint = 0.022f,
                                           .relief = 0.018f,
                                           .block = Rgb(0.58f, 0.56f, 0.54f),
                                           .mortar = Rgb(0.45f, 0.44f, 0.43f),
                                           .variation = 0.15f});
    const Rgb gray(0.6f, 0.6f, 0.6f);
    return {scene.add_patterned("bricks", bricks, texture_pixels),
            scene.add_bumped("domes", gray, domes(3, 0.84f, slope_60_degrees), texture_pixels),
            scene.add_bumped("ridges", gray, ridges(5, slope_55_degrees), texture_pixels),
            scene.add_diffuse("plain", {0.65f, 0.65f, 0.65f})};
}

void add_shell(SceneDescription& scene, const Materials& materials) {
    const auto panel = ceiling_rectangle(room, {0.6f, -1.9f}, {2.6f, -0.3f});
    MeshBuilder back(texture_size), floor(texture_size), sides(texture_size), plain, light;
    add_box_side(back, room, Side::back, Facing::inward);
    add_box_side(floor, room, Side::bottom, Facing::inward);
    add_box_side(sides, room, Side::left, Facing::inward);
    add_box_side(sides, room, Side::right, Facing::inward);
    add_box_side(plain, room, Side::front, Facing::inward);
    add_ceiling_around(plain, room, panel);
    light.add_quad(panel);

    scene.place("back_wall", back, materials.bricks);
    scene.place("floor", floor, materials.domes);
    scene.place("side_walls", sides, materials.ridges);
    scene.place("front_and_ceiling", plain, materials.plain);
    scene.place("soft_panel", light, scene.add_emitter("soft_panel", {7.0f, 7.0f, 7.0f}));
}

}  // namespace

SceneDescription make_bumpy() {
    SceneDescription scene;
    const Materials materials = add_materials(scene);
    add_shell(scene, materials);

    MeshBuilder faces(texture_size), edge;
    add_box(faces, partition, {Side::bottom, Side::top, Side::back, Side::front});
    add_box_side(edge, partition, Side::front, Facing::outward);
    scene.place("partition", faces, materials.domes);
    scene.place("partition_edge", edge, materials.plain);

    scene.add_spot_light({-0.8f, 2.8f, -0.9f}, {-1.9f, 0.3f, -1.6f}, {60.0f, 60.0f, 60.0f}, 45, 65);
    scene.add_camera("front", {0, 1.65f, 2.15f}, {0, 1.25f, -2.0f}, 58);
    return scene;
}

}  // namespace scenes
