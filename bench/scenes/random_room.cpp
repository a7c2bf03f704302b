// Random furnished rooms, for tests of fit's promise on scenes that it was not made for.
#include <fmt/format.h>

#include <random>

#include "bench/scenes/scenes.h"
#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

constexpr int texture_pixels = 256;

/// Random numbers that are the same everywhere; distributions of the standard library differ.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}

    [[nodiscard]] float between(float least, float most) {
        return least + (most - least) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
    }
    [[nodiscard]] int one_of(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    [[nodiscard]] bool chance(float probability) { return between(0, 1) < probability; }

    [[nodiscard]] Rgb colour(float least, float most) {
        const float grey = between(least, most), tint = between(0, 0.25f);
        const auto channel = [&] { return std::clamp(grey + between(-tint, tint), 0.03f, 0.85f); };
        const float red = channel(), green = channel(), blue = channel();
        return {red, green, blue};
    }

  private:
    std::mt19937 engine_;
};

class RoomMaker {
  public:
    explicit RoomMaker(std::uint32_t seed) : dice_(seed) {
        const float x = dice_.between(1.5f, 4), y = dice_.between(2.3f, 4), z = dice_.between(1.5f, 4);
        room_ = {{-x, 0, -z}, {x, y, z}};
    }

    [[nodiscard]] SceneDescription make() {
        add_shell();
        for (int lamps = dice_.one_of(3); lamps > 0; --lamps) add_lamp();
        for (int boxes = 1 + dice_.one_of(6); boxes > 0; --boxes) add_box_on_floor();
        for (int shelves = dice_.one_of(3); shelves > 0; --shelves) add_shelf();
        if (dice_.chance(0.4f)) add_ball();
        add_view();
        return std::move(scene_);
    }

  private:
    [[nodiscard]] std::string next(const char* kind) { return fmt::format("{}_{}", kind, count_++); }

    [[nodiscard]] int surface(const std::string& name) {
        const Rgb albedo = dice_.colour(0.2f, 0.75f);
        switch (dice_.one_of(8)) {
            case 0:
                return scene_.add_patterned(name,
                                            masonry({.columns = 2 + dice_.one_of(3),
                                                     .courses = 4 + dice_.one_of(5),
                                                     .running_bond = true,
                                                     .joint = 0.02f,
                                                     .relief = 0.015f,
                                                     .block = albedo,
                                                     .mortar = 0.7f * albedo,
                                                     .variation = 0.2f}),
                                            texture_pixels);
            case 1:
                return scene_.add_patterned(name, wood(albedo), texture_pixels);
            case 2:
                return scene_.add_patterned(name, plaster(albedo), texture_pixels);
            case 3:
                return scene_.add_bumped(
                    name, albedo, domes(2 + dice_.one_of(4), dice_.between(0.5f, 1), dice_.between(0.2f, 1)),
                    texture_pixels);
            case 4:
                return scene_.add_bumped(name, albedo, ridges(2 + dice_.one_of(6), dice_.between(0.2f, 1)),
                                         texture_pixels);
            default:
                return scene_.add_diffuse(name, albedo);
        }
    }

    /// Adds the shell, always with a lamp panel in its ceiling, so that no room is dark.
    void add_shell() {
        const float half_x = dice_.between(0.1f, 0.6f), half_z = dice_.between(0.1f, 0.6f);
        const float x = dice_.between(room_.min.x + 0.8f, room_.max.x - 0.8f);
        const float z = dice_.between(room_.min.z + 0.8f, room_.max.z - 0.8f);
        const auto panel = ceiling_rectangle(room_, {x - half_x, z - half_z}, {x + half_x, z + half_z});
        const float watts = dice_.between(4, 12) / (half_x * half_z);
        MeshBuilder floor(dice_.between(0.7f, 2)), sides(dice_.between(0.7f, 2)),
            back(dice_.between(0.7f, 2)), plain, light;
        add_box_side(floor, room_, Side::bottom, Facing::inward);
        for (const Side side : {Side::left, Side::right}) add_box_side(sides, room_, side, Facing::inward);
        add_box_side(back, room_, Side::back, Facing::inward);
        add_box_side(plain, room_, Side::front, Facing::inward);
        add_ceiling_around(plain, room_, panel);
        light.add_quad(panel);
        scene_.place("floor", floor, surface("floor"));
        scene_.place("sides", sides, surface("sides"));
        scene_.place("back", back, surface("back"));
        scene_.place("plain", plain, scene_.add_diffuse("plain", dice_.colour(0.4f, 0.8f)));
        scene_.place("panel", light, scene_.add_emitter("panel", watts * lamp_colour()));
    }

    [[nodiscard]] Rgb lamp_colour() { return {1, dice_.between(0.7f, 1), dice_.between(0.45f, 1)}; }

    /// Adds a hanging box that emits on all sides, a bare bulb or a spot.
    void add_lamp() {
        const Vec3 at(dice_.between(room_.min.x + 0.5f, room_.max.x - 0.5f),
                      dice_.between(1.6f, room_.max.y - 0.3f),
                      dice_.between(room_.min.z + 0.5f, room_.max.z - 0.5f));
        const Rgb colour = lamp_colour();
        switch (dice_.one_of(3)) {
            case 0: {
                const float half = dice_.between(0.03f, 0.15f);
                MeshBuilder lamp;
                add_box(lamp, {at - Vec3(half), at + Vec3(half)});
                const std::string name = next("lamp");
                scene_.place(name, lamp,
                             scene_.add_emitter(name, dice_.between(0.3f, 1.5f) / (half * half) * colour));
                return;
            }
            case 1:
                return scene_.add_point_light(at, dice_.between(3, 12) * colour);
            default:
                return scene_.add_spot_light(
                    at, {dice_.between(room_.min.x, room_.max.x), 0, dice_.between(room_.min.z, room_.max.z)},
                    dice_.between(10, 40) * colour, dice_.between(10, 25), dice_.between(26, 50));
        }
    }

    void add_box_on_floor() {
        const Vec3 half(dice_.between(0.15f, 0.5f), dice_.between(0.2f, 1.4f), dice_.between(0.15f, 0.5f));
        const Vec3 foot(dice_.between(room_.min.x + 0.7f, room_.max.x - 0.7f), 0,
                        dice_.between(room_.min.z + 0.7f, 0.4f * room_.max.z));
        MeshBuilder box(0.8f);
        add_box(box, {{-half.x, 0, -half.z}, {half.x, half.y, half.z}}, {Side::bottom});
        const std::string name = next("box");
        scene_.place(name, scene_.add_mesh(box.finish()), surface(name), turned(dice_.between(0, 90), foot));
    }

    /// Adds boards on the back wall, with deep shadows between them.
    void add_shelf() {
        const float width = dice_.between(0.5f, 1.4f), depth = dice_.between(0.15f, 0.4f);
        const float left = dice_.between(room_.min.x + 0.1f, room_.max.x - width - 0.1f);
        const float thickness = dice_.between(0.015f, 0.05f);
        MeshBuilder boards(0.8f);
        float height = dice_.between(0.3f, 0.9f);
        for (int board = 2 + dice_.one_of(3); board > 0 && height < room_.max.y - 0.3f; --board) {
            add_box(boards,
                    {{left, height, room_.min.z}, {left + width, height + thickness, room_.min.z + depth}},
                    {Side::back});
            height += dice_.between(0.2f, 0.5f);
        }
        const std::string name = next("shelf");
        scene_.place(name, boards, surface(name));
    }

    void add_ball() {
        const float radius = dice_.between(0.15f, 0.4f);
        const Vec3 centre(dice_.between(room_.min.x + 0.5f, room_.max.x - 0.5f), radius + 0.02f,
                          dice_.between(room_.min.z + 0.5f, 0.4f * room_.max.z));
        MeshBuilder ball(0.5f);
        add_sphere(ball, centre, radius, 8);
        const std::string name = next("ball");
        scene_.place(name, ball, surface(name));
    }

    void add_view() {
        const Vec3 eye(dice_.between(0.5f * room_.min.x, 0.5f * room_.max.x), dice_.between(1.1f, 1.8f),
                       room_.max.z - 0.1f);
        const Vec3 target(dice_.between(-0.5f, 0.5f), dice_.between(0.5f, 1.2f), room_.min.z);
        scene_.add_camera("view", eye, target, dice_.between(45, 70));
    }

    Dice dice_;
    Box room_;
    SceneDescription scene_;
    int count_ = 0;
};

}  // namespace

SceneDescription make_random_room(std::uint32_t seed) {
    return RoomMaker(seed).make();
}

}  // namespace scenes
