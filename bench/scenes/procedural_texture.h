// Small tileable textures computed from formulas: colours from albedo, normal maps from height.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/core/vector.h"

namespace scenes {

using common::Rgb;
using common::Vec2;

/// 8-bit RGB, rows from the top (v = 0) down.
struct Image {
    std::string name;
    int size;  ///< width and height in pixels
    std::vector<std::uint8_t> rgb;
};

/// Linear albedo at (u, v), both in [0, 1); v runs down the image. Tileable.
using Albedo = std::function<Rgb(Vec2 uv)>;

/// Height at (u, v) in units of the tile's width, so that its gradient is the true slope. Tileable.
using Height = std::function<float(Vec2 uv)>;

[[nodiscard]] Image make_color_image(const std::string& name, int size,
                                     const Albedo& albedo);  ///< sRGB encoded

/// Tangent-space normal map as glTF defines it: red along +u, green up the image (-v), blue out of the
/// surface.
[[nodiscard]] Image make_normal_image(const std::string& name, int size, const Height& height);

/// Fixed hash of three integers to [0, 1).
[[nodiscard]] float hash_to_unit(int x, int y, std::uint32_t seed);

/// Smooth noise in [0, 1] on a lattice of `cells` x `cells`, tileable.
[[nodiscard]] float value_noise(Vec2 uv, int cells, std::uint32_t seed);

/// Sum of `octaves` value noises, each twice as fine and half as strong; in [0, 1], tileable.
[[nodiscard]] float fractal_noise(Vec2 uv, int cells, int octaves, std::uint32_t seed);

}  // namespace scenes
