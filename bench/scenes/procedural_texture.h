// Small tileable textures from formulas: colours from albedo, normal maps from height.
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

/// Returns the linear albedo at (u, v), both in [0, 1); v runs down the image. Tileable.
using Albedo = std::function<Rgb(Vec2 uv)>;

/// Returns the height at (u, v) in units of the tile's width, so that its gradient is the true slope.
/// Tileable.
using Height = std::function<float(Vec2 uv)>;

[[nodiscard]] Image make_color_image(const std::string& name, int size,
                                     const Albedo& albedo);  ///< sRGB encoded

/// Makes a tangent-space normal map as glTF defines it: red along +u, green up the image (-v), blue out of
/// the surface.
[[nodiscard]] Image make_normal_image(const std::string& name, int size, const Height& height);

/// Returns a fixed hash of three integers in [0, 1).
[[nodiscard]] float hash_to_unit(int x, int y, std::uint32_t seed);

/// Returns smooth noise in [0, 1] on a lattice of `cells` x `cells`, tileable.
[[nodiscard]] float value_noise(Vec2 uv, int cells, std::uint32_t seed);

/// Returns the sum of `octaves` value noises, each with twice the frequency and half the amplitude of the one
/// before; in [0, 1], tileable.
[[nodiscard]] float fractal_noise(Vec2 uv, int cells, int octaves, std::uint32_t seed);

}  // namespace scenes
