#include "bench/scenes/ornaments.h"

#include <numbers>

#include "bench/scenes/shapes.h"

namespace scenes {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float cloth_texture = 0.35f;  ///< metres
constexpr float stone_texture = 1.0f;   ///< metres

float smooth_between(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

Vec3 on_trefoil(float scale, float angle) {
    return Vec3(std::sin(angle) + 2 * std::sin(2 * angle), std::cos(angle) - 2 * std::cos(2 * angle),
                -std::sin(3 * angle)) *
           scale;
}

constexpr float shade_height = 0.22f;

}  // namespace

Mesh make_tied_curtain(float rod_height, float width, float tie_height) {
    constexpr float hem_height = 0.03f, folds = 5;
    MeshBuilder builder(cloth_texture);
    builder.add_surface({96, 26}, [=](float s, float t) {
        const float y = hem_height + (rod_height - hem_height) * t;
        const float above = smooth_between(tie_height, rod_height, y);
        const float below = smooth_between(tie_height, hem_height - 0.8f * tie_height, y);
        const float gathered = 0.34f;
        const float spread = y > tie_height ? gathered + (1 - gathered) * above : gathered + 0.3f * below;
        const float fold_depth = 0.045f + 0.03f * (1 - spread);
        const float phase = 2 * pi * folds * s + 0.5f * std::sin(2.5f * y + 3 * s);
        const float drift = 0.02f * std::sin(3 * y + 5 * s);
        return Vec3(width * spread * s, y, fold_depth * std::sin(phase) + drift);
    });
    return builder.finish();
}

Mesh make_banner(float width, float height) {
    MeshBuilder builder(cloth_texture);
    builder.add_surface({16, 24}, [=](float s, float t) {
        const float hang = 1 - t;
        const float wave = 0.05f * hang * std::sin(5 * s + 4 * t) + 0.03f * hang * std::sin(9 * s - 3 * t);
        const float swallowtail = 0.35f * std::abs(s - 0.5f) * hang * hang;
        return Vec3(width * (s - 0.5f), -(height - swallowtail) * hang, wave);
    });
    return builder.finish();
}

Mesh make_vase(float height) {
    const float h = height;
    const std::array<Vec2, 9> outside{{{0.17f * h, 0},
                                       {0.18f * h, 0.04f * h},
                                       {0.13f * h, 0.10f * h},
                                       {0.24f * h, 0.30f * h},
                                       {0.33f * h, 0.55f * h},
                                       {0.27f * h, 0.76f * h},
                                       {0.17f * h, 0.88f * h},
                                       {0.20f * h, 0.97f * h},
                                       {0.24f * h, h}}};
    const std::array<Vec2, 7> inside{{{0.24f * h, h},
                                      {0.18f * h, 0.97f * h},
                                      {0.15f * h, 0.88f * h},
                                      {0.25f * h, 0.75f * h},
                                      {0.30f * h, 0.55f * h},
                                      {0.20f * h, 0.32f * h},
                                      {0, 0.26f * h}}};
    MeshBuilder builder(stone_texture);
    add_lathe(builder, origin, smooth_curve(outside), 32, 24);
    add_lathe(builder, origin, smooth_curve(inside), 32, 10);
    return builder.finish();
}

Mesh make_pedestal(float radius, float height) {
    const float r = radius, step = 0.16f;
    const std::array<Vec2, 7> body{{{0.86f * r, step},
                                    {0.84f * r, step + 0.06f},
                                    {0.70f * r, step + 0.16f},
                                    {0.68f * r, 0.5f * (step + height)},
                                    {0.70f * r, height - 0.22f},
                                    {0.84f * r, height - 0.12f},
                                    {0.86f * r, height - 0.06f}}};
    constexpr int segments = 64;
    MeshBuilder builder(stone_texture);
    add_lathe(builder, origin, straight_curve({1.15f * r, 0}, {1.15f * r, step}), segments, 1);
    add_lathe(builder, origin, straight_curve({1.15f * r, step}, {0.8f * r, step}), segments, 2);
    add_lathe(builder, origin, smooth_curve(body), segments, 20);
    add_lathe(builder, origin, straight_curve({0.86f * r, height - 0.06f}, {0.92f * r, height - 0.06f}),
              segments, 1);
    add_lathe(builder, origin, straight_curve({0.92f * r, height - 0.06f}, {0.92f * r, height}), segments, 1);
    add_lathe(builder, origin, straight_curve({0.92f * r, height}, {0, height}), segments, 4);
    return builder.finish();
}

Mesh make_trefoil_knot(float radius, float tube_radius) {
    const float scale = (radius - tube_radius) / 3;
    MeshBuilder builder(stone_texture);
    builder.add_surface({16, 200}, [=](float s, float t) {
        const float angle = 2 * pi * (t - std::floor(t)), step = 1e-2f;  // the tube closes on itself
        const Vec3 centre = on_trefoil(scale, angle);
        const Vec3 tangent = (on_trefoil(scale, angle + step) - on_trefoil(scale, angle - step)).normalized();
        const Vec3 side = (tangent % Vec3(0, 0, 1)).normalized();
        const Vec3 up = side % tangent;
        const float around = -2 * pi * s;
        return centre + (side * std::cos(around) + up * std::sin(around)) * tube_radius;
    });
    return builder.finish();
}

Mesh make_pendant(float rod_length) {
    const float top = -rod_length, rod_radius = 0.015f;
    const std::array<Vec2, 4> outside{{{0.24f, top - shade_height},
                                       {0.21f, top - 0.55f * shade_height},
                                       {0.13f, top - 0.15f * shade_height},
                                       {0, top}}};
    const std::array<Vec2, 4> inside{{{0, top - 0.01f},
                                      {0.12f, top - 0.17f * shade_height},
                                      {0.20f, top - 0.56f * shade_height},
                                      {0.23f, top - shade_height}}};
    MeshBuilder builder(stone_texture);
    add_lathe(builder, origin, straight_curve({rod_radius, top - 0.005f}, {rod_radius, 0}), 12, 6);
    add_lathe(builder, origin, smooth_curve(outside), 28, 6);
    add_lathe(builder, origin, smooth_curve(inside), 28, 6);
    add_lathe(builder, origin, straight_curve({0.23f, top - shade_height}, {0.24f, top - shade_height}), 28,
              1);
    return builder.finish();
}

float pendant_light_height(float rod_length) {
    return -rod_length - 0.6f * shade_height;
}

}  // namespace scenes
