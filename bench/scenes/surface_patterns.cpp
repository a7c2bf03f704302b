#include "bench/scenes/surface_patterns.h"

#include <numbers>

namespace scenes {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

Rgb gray(float x) {
    return Rgb(x, x, x);
}

float smooth_between(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

struct BlockHit {
    int column, course;
    float edge_distance;  ///< to the middle of the nearest joint, in tile widths
};

BlockHit find_block(const Masonry& m, Vec2 uv) {
    const float course_position = uv.y * static_cast<float>(m.courses);
    const int course = static_cast<int>(course_position);
    const float shift = m.running_bond && course % 2 == 1 ? 0.5f : 0.0f;
    const float column_position = uv.x * static_cast<float>(m.columns) + shift;
    const float x = column_position - std::floor(column_position);
    const float y = course_position - static_cast<float>(course);
    const float across = std::min(x, 1 - x) / static_cast<float>(m.columns);
    const float down = std::min(y, 1 - y) / static_cast<float>(m.courses);
    return {static_cast<int>(column_position) % m.columns, course, std::min(across, down)};
}

/// Returns 0 in the joint and 1 on the block.
float block_mask(const Masonry& m, const BlockHit& hit) {
    return smooth_between(0.4f * m.joint, m.joint, hit.edge_distance);
}

}  // namespace

SurfacePattern masonry(const Masonry& m) {
    const Albedo albedo = [m](Vec2 uv) {
        const BlockHit hit = find_block(m, uv);
        const float tone = hash_to_unit(hit.column, hit.course, 7) - 0.5f;
        const float grain = fractal_noise(uv, 16, 4, 11) - 0.5f;
        const float mask = block_mask(m, hit);
        return (m.mortar * (1 - mask) + m.block * (1 + m.variation * tone) * mask) * (1 + 0.3f * grain);
    };
    const Height height = [m](Vec2 uv) {
        const float mask = block_mask(m, find_block(m, uv));
        return m.relief * mask + 0.1f * m.relief * fractal_noise(uv, 24, 3, 13);
    };
    return {albedo, height};
}

SurfacePattern plaster(const Rgb& albedo) {
    return {[albedo](Vec2 uv) { return albedo * (0.88f + 0.24f * fractal_noise(uv, 4, 5, 21)); },
            [](Vec2 uv) { return 0.004f * fractal_noise(uv, 12, 4, 22); }};
}

SurfacePattern marble(const Rgb& albedo) {
    const Albedo veined = [albedo](Vec2 uv) {
        const float warp = fractal_noise(uv, 3, 5, 31);
        const float vein = std::abs(std::sin(2 * pi * (uv.x + 2 * uv.y + 1.5f * warp)));
        return albedo * (0.75f + 0.25f * smooth_between(0.0f, 0.35f, vein)) *
               (0.92f + 0.16f * fractal_noise(uv, 8, 4, 33));
    };
    return {veined, {}};
}

SurfacePattern wood(const Rgb& albedo) {
    constexpr int boards = 4;
    const auto joint_distance = [](Vec2 uv) {
        const float x = uv.x * boards - std::floor(uv.x * boards);
        return std::min(x, 1 - x) / boards;
    };
    const Albedo grain = [albedo, joint_distance](Vec2 uv) {
        const int board = static_cast<int>(uv.x * boards);
        const float tone = 0.8f + 0.4f * hash_to_unit(board, 0, 41);
        const float wave = fractal_noise(uv, 4, 3, 42);
        const float ring = 0.5f + 0.5f * std::sin(2 * pi * (24 * uv.x + 3 * wave));
        const float joint = smooth_between(0.002f, 0.006f, joint_distance(uv));
        return albedo * (tone * (0.8f + 0.3f * ring) * (0.35f + 0.65f * joint));
    };
    const Height relief = [joint_distance](Vec2 uv) {
        return 0.006f * smooth_between(0.002f, 0.01f, joint_distance(uv));
    };
    return {grain, relief};
}

SurfacePattern cloth() {
    constexpr int threads = 32;
    const auto thread_height = [](Vec2 uv) {
        const float warp = std::sin(2 * pi * threads * uv.x), weft = std::sin(2 * pi * threads * uv.y);
        return std::max(std::abs(warp) * (weft > 0 ? 1.0f : 0.6f), std::abs(weft) * (warp > 0 ? 1.0f : 0.6f));
    };
    return {
        [thread_height](Vec2 uv) {
            return gray((0.82f + 0.18f * thread_height(uv)) * (0.9f + 0.1f * fractal_noise(uv, 6, 3, 51)));
        },
        [thread_height](Vec2 uv) { return 0.003f * thread_height(uv); }};
}

Height domes(int per_side, float radius_fraction, float steepest_slope) {
    return [=](Vec2 uv) {
        const auto from_centre = [&](float x) {
            const float cell = x * static_cast<float>(per_side);
            return (cell - std::floor(cell) - 0.5f) / static_cast<float>(per_side);
        };
        const float distance = Vec2(from_centre(uv.x), from_centre(uv.y)).length();
        const float rim = radius_fraction * 0.5f / static_cast<float>(per_side);
        const float sphere_radius = rim / std::sin(steepest_slope);
        if (distance >= rim) return 0.0f;
        return std::sqrt(sphere_radius * sphere_radius - distance * distance) -
               sphere_radius * std::cos(steepest_slope);
    };
}

Height ridges(int per_tile, float steepest_slope) {
    return [=](Vec2 uv) {
        const float frequency = 2 * pi * static_cast<float>(per_tile);
        return std::tan(steepest_slope) / frequency * std::sin(frequency * uv.x);
    };
}

}  // namespace scenes
