#include "bench/scenes/procedural_texture.h"

namespace scenes {
namespace {

std::uint8_t to_byte(float x) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(x, 0.0f, 1.0f)));
}

float encode_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

int wrap(int x, int period) {
    return ((x % period) + period) % period;
}

float smooth_step(float x) {
    return x * x * (3 - 2 * x);
}

Image make_image(const std::string& name, int size, const std::function<Rgb(Vec2)>& pixel) {
    Image image{name, size, {}};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const Rgb value = pixel(centre / static_cast<float>(size));
            for (float channel : {value.x, value.y, value.z}) image.rgb.push_back(to_byte(channel));
        }
    }
    return image;
}

}  // namespace

Image make_color_image(const std::string& name, int size, const Albedo& albedo) {
    return make_image(name, size, [&](Vec2 uv) {
        const Rgb linear = albedo(uv);
        return Rgb(encode_srgb(linear.x), encode_srgb(linear.y), encode_srgb(linear.z));
    });
}

Image make_normal_image(const std::string& name, int size, const Height& height) {
    const float step = 0.5f / static_cast<float>(size);
    return make_image(name, size, [&](Vec2 uv) {
        const auto slope = [&](Vec2 offset) {
            const auto tiled = [](float x) { return x - std::floor(x); };
            const Vec2 ahead = uv + offset, behind = uv - offset;
            return (height({tiled(ahead.x), tiled(ahead.y)}) - height({tiled(behind.x), tiled(behind.y)})) /
                   (2 * step);
        };
        const common::Vec3 normal = common::Vec3(-slope({step, 0}), slope({0, step}), 1.0f).normalized();
        return Rgb(0.5f + 0.5f * normal.x, 0.5f + 0.5f * normal.y, 0.5f + 0.5f * normal.z);
    });
}

float hash_to_unit(int x, int y, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b9u + static_cast<std::uint32_t>(x) * 0x85ebca6bu +
                      static_cast<std::uint32_t>(y) * 0xc2b2ae35u;
    for (int round = 0; round < 3; ++round) h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return static_cast<float>((h ^ (h >> 16)) >> 8) * 0x1p-24f;
}

float value_noise(Vec2 uv, int cells, std::uint32_t seed) {
    const Vec2 p = uv * static_cast<float>(cells);
    const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
    const float u = smooth_step(p.x - static_cast<float>(x)), v = smooth_step(p.y - static_cast<float>(y));
    const auto lattice = [&](int i, int j) { return hash_to_unit(wrap(i, cells), wrap(j, cells), seed); };
    const float above = lattice(x, y) * (1 - u) + lattice(x + 1, y) * u;
    const float below = lattice(x, y + 1) * (1 - u) + lattice(x + 1, y + 1) * u;
    return above * (1 - v) + below * v;
}

float fractal_noise(Vec2 uv, int cells, int octaves, std::uint32_t seed) {
    float sum = 0, weight = 1, total = 0;
    for (int octave = 0; octave < octaves; ++octave, cells *= 2, weight *= 0.5f) {
        sum += weight * value_noise(uv, cells, seed + static_cast<std::uint32_t>(octave));
        total += weight;
    }
    return sum / total;
}

}  // namespace scenes
