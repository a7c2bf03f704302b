// The closed box that every renderer is tested with: few triangles, large flat charts, strong colour
// bleeding.
#include "bench/scenes/scenes.h"
#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

const Box room{{-1.2f, 0, -1.2f}, {1.2f, 2, 2.8f}};

void add_walls(SceneDescription& scene) {
    const auto lamp = ceiling_rectangle(room, {-0.35f, -0.3f}, {0.35f, 0.3f});
    MeshBuilder white, left, right, light;
    add_box_side(white, room, Side::bottom, Facing::inward);
    add_box_side(white, room, Side::back, Facing::inward);
    add_box_side(white, room, Side::front, Facing::inward);
    add_ceiling_around(white, room, lamp);
    add_box_side(left, room, Side::left, Facing::inward);
    add_box_side(right, room, Side::right, Facing::inward);
    light.add_quad(lamp);

    scene.place("walls", white, scene.add_diffuse("white", {0.7f, 0.7f, 0.7f}));
    scene.place("left_wall", left, scene.add_diffuse("red", {0.63f, 0.06f, 0.05f}));
    scene.place("right_wall", right, scene.add_diffuse("green", {0.12f, 0.45f, 0.10f}));
    scene.place("lamp", light, scene.add_emitter("lamp", {27.0f, 22.0f, 15.0f}));
}

void add_block(SceneDescription& scene, const std::string& name, const Vec3& size, float degrees,
               const Vec3& foot, int material) {
    MeshBuilder block;
    add_box(block, {{-size.x / 2, 0, -size.z / 2}, {size.x / 2, size.y, size.z / 2}}, {Side::bottom});
    scene.place(name, scene.add_mesh(block.finish()), material, turned(degrees, foot));
}

}  // namespace

SceneDescription make_cornell() {
    SceneDescription scene;
    add_walls(scene);
    const int block = scene.add_diffuse("block", {0.68f, 0.68f, 0.66f});
    add_block(scene, "tall_block", {0.6f, 1.2f, 0.6f}, 18, {-0.42f, 0, -0.4f}, block);
    add_block(scene, "short_block", {0.6f, 0.6f, 0.6f}, -17, {0.45f, 0, 0.2f}, block);
    scene.add_camera("front", {0, 1.02f, 2.75f}, {0, 0.9f, 0}, 46);
    return scene;
}

}  // namespace scenes
